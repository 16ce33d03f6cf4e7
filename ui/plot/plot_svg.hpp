#pragma once

#include <string>
#include <vector>

#include "plot/plot.hpp"

namespace myo::ui::plot {

/// Returns charts below each other as a vector drawing (SVG 1.1) in the colours of the theme, 800 pixels wide. Curves
/// reach to the ends of the x range; a NaN leaves a gap. Without charts the drawing is empty.
std::string plots_svg(const std::vector<chart::Chart>& charts, const platform::Theme& theme);

}  // namespace myo::ui::plot
