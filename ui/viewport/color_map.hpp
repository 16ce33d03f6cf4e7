#pragma once

#include <Eigen/Core>

namespace myo {

/// Perceptual colour map from dark blue through green to yellow: lightness rises evenly, so it reads in grey too.
/// @param level  0 to 1, clamped   @return red, green, blue, 0 to 1
Eigen::Vector3f color_map(double level);

}  // namespace myo
