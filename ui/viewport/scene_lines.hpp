#pragma once

#include <vector>

#include "viewport/scene.hpp"

namespace myo::ui::viewport {

/// Appends the segments of a line in the format of the line shader: from, to [m], colour; 10 floats each. Segments with
/// an end that is not finite are left out.
void append_segments(std::vector<float>& segments, const DrawnLine& line);

/// Segments of the ground grid below the body, in squares of 1, 2 or 5 times a power of ten [m], fading outwards. Empty
/// if the box has no extent.
std::vector<float> grid_segments(const Box& extent, const Color& color);

/// An arrow as one polyline: a shaft and four barbs, then a gap.
Eigen::Matrix<double, 3, 10> arrow_points(const Eigen::Vector3d& from, const Eigen::Vector3d& along);

/// The 12 edges of a box [m] as lines of `width` pixels.
std::vector<DrawnLine> box_lines(const Box& box, const Color& color, double width);

}  // namespace myo::ui::viewport
