#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::ui::viewport {

/// Perceptual colour map from dark blue through green to yellow: lightness rises evenly, so it reads in grey too.
/// @param level  0 to 1, clamped   @return red, green, blue, 0 to 1
Eigen::Vector3f color_map(double level);

/// For values with a sign: blue below the middle, pale in it, red above; equally light at equal distance from it.
Eigen::Vector3f diverging_color_map(double level);

/// One of those that a person can choose for values without a sign.
struct ColorMap {
    std::string id, label, explanation;
    Eigen::Vector3f (*color)(double level);
};

/// The choice, the usual one first. In each lightness rises evenly.
const std::vector<ColorMap>& color_maps();

/// Place of a map in color_maps(); 0 for an id that is not there.
int number_of_color_map(const std::string& id);

}  // namespace myo::ui::viewport
