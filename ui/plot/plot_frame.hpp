#pragma once

#include "plot/plot.hpp"

namespace myo::ui::plot {

/// Draws background, grid lines, tick labels and the zero line of a plot. The labels are placed outside the area.
void draw_plot_frame(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme);

/// Draws one curve. Points far outside the area are left out; the caller clips to the area.
void draw_plot_series(ImDrawList& list, const PlotSeries& series, const PlotArea& area, const platform::Theme& theme);

/// Draws the legend above the upper right corner of the area. A click on an entry hides or shows its curve in `hidden`.
void draw_plot_legend(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme,
                      platform::ItemRectangles& items, HiddenSeries& hidden);

/// Draws hair lines at the mouse, and a tooltip with the values of all visible curves at the sample nearest to it.
void draw_plot_crosshair(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme,
                         const HiddenSeries& hidden);

/// Index of the sample whose x is nearest to `value`. x is ascending. Returns -1 if there are no samples.
Eigen::Index nearest_sample(const Eigen::VectorXd& x, double value);

}  // namespace myo::ui::plot
