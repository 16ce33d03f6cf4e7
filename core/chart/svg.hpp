#pragma once

#include <string>
#include <vector>

#include "chart/drawing.hpp"

namespace myo::chart {

/// SVG document of a drawing. Only finite numbers are written. Without ids, which could clash with those of other
/// figures of a page. Equal drawings give equal text, independent of the locale.
///
/// @param sized  with the frame's width and height, for a file of its own; otherwise the picture fills its column
std::string svg(const Drawing& drawing, bool sized = false);

/// SVG document of a chart on white paper, without fixed width; text widths are estimated.
std::string svg(const Chart& chart);

}  // namespace myo::chart
