#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::ui::viewport {

/// Perceptual colour map from dark violet through green to yellow. Lightness rises linearly, so it is readable in grey,
/// too.
///
/// @param level  0 to 1; limited to this range
/// @return red, green, blue, 0 to 1
Eigen::Vector3f color_map(double level);

/// Colour map for signed values: blue below the middle, pale at it, red above. Equal distances from the middle have
/// equal lightness. `level` as above; 0.5 is the middle.
Eigen::Vector3f diverging_color_map(double level);

/// A colour map that the user can choose for unsigned values.
struct ColorMap {
    std::string id, label, explanation;      // id: in project files; label and explanation: shown
    Eigen::Vector3f (*color)(double level);  // level 0 to 1 -> red, green, blue
};

/// Colour maps to choose from, the default first. Lightness rises linearly in each. The order is the order of the rows
/// in the renderer's texture.
const std::vector<ColorMap>& color_maps();

/// Index of a map in color_maps(). Returns 0, the default, for an unknown id.
int number_of_color_map(const std::string& id);

}  // namespace myo::ui::viewport
