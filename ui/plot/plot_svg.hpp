#pragma once

#include <string>
#include <vector>

#include "plot/plot.hpp"

namespace myo::ui::plot {

/// A plot and the visible part of it. Its series are the visible curves only.
struct SeenPlot {
    Plot plot;
    Range x;  // visible range
    Range y;  // visible range
};

/// Returns plots below each other as a vector drawing (SVG 1.1) in the colours of the theme: axes, ticks with units,
/// legend and curves.
///
/// Curves are interpolated to the ends of the x range. Each sample inside both ranges gets a dot if the series has
/// dots. A NaN in y leaves a gap. Without plots the drawing is empty.
std::string plots_svg(const std::vector<SeenPlot>& plots, const platform::Theme& theme);

}  // namespace myo::ui::plot
