#pragma once

#include <vector>

#include "viewport/scene.hpp"

namespace myo::ui::viewport {

/// Segments as the line shader takes them: from, to, colour; 10 floats each. Pieces with a non-finite end are left out.
void append_segments(std::vector<float>& segments, const DrawnLine& line);

/// Ground grid under the body: squares of 1, 2 or 5 times a power of ten, fading outwards.
std::vector<float> grid_segments(const Box& extent, const Color& color);

/// The 12 edges of a box as lines.
std::vector<DrawnLine> box_lines(const Box& box, const Color& color, double width);

}  // namespace myo::ui::viewport
