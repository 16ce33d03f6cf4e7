#pragma once

#include <Eigen/Core>

namespace myo {

/// Perceptual colour map from dark blue through green to yellow: lightness rises evenly, so it reads in grey too.
/// @param level  0 to 1, clamped   @return red, green, blue, 0 to 1
Eigen::Vector3f color_map(double level);

/// For values with a sign: blue below the middle, pale in it, red above; equally light at equal distance from it.
Eigen::Vector3f diverging_color_map(double level);

}  // namespace myo
