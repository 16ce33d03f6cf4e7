#pragma once

#include "plot/plot.hpp"

namespace myo::ui::plot {

/// Axes, grid lines and labels.
void draw_plot_frame(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme);

/// Curves, clipped to the area.
void draw_plot_series(ImDrawList& list, const PlotSeries& series, const PlotArea& area, const platform::Theme& theme);

/// Names with colour samples in the upper right corner; a click shows or hides a series.
void draw_plot_legend(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme,
                      platform::ItemRectangles& items, HiddenSeries& hidden);

/// Hair lines at the mouse and the values of all visible series at the sample next to it.
void draw_plot_crosshair(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme,
                         const HiddenSeries& hidden);

/// Index of the x nearest to `value`; -1 when empty. x ascending.
Eigen::Index nearest_sample(const Eigen::VectorXd& x, double value);

}  // namespace myo::ui::plot
