#pragma once

#include <string>
#include <vector>

#include "plot/plot.hpp"

namespace myo::ui::plot {

/// A plot with the part of it that is seen; its series are those that are shown.
struct SeenPlot {
    Plot plot;
    Range x;
    Range y;
};

/// The plots below each other as a vector drawing (SVG 1.1) in the colours of the theme: axes, ticks with units, legend
/// and curves. Curves end at the edges of the x range, interpolated there; a dot for each sample inside both ranges; a
/// gap where y is NaN.
std::string plots_svg(const std::vector<SeenPlot>& plots, const platform::Theme& theme);

}  // namespace myo::ui::plot
