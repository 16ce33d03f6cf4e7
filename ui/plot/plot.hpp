#pragma once

#include <imgui.h>

#include <Eigen/Core>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "chart/layout.hpp"
#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"

namespace myo::ui::plot {

/// A curve of a plot; if the lengths differ, the shorter one counts. x is ascending.
///
/// @param name  in the legend; also identifies the curve in HiddenSeries
/// @param dots  dots at the samples instead of a line
chart::Series plot_series(std::string name, const Eigen::VectorXd& x, const Eigen::VectorXd& y, const ImVec4& color,
                          bool dots = false);

/// Content of a plot in this frame. A panel builds a new one for each frame; the plot keeps nothing of it.
struct Plot {
    std::string id;                                  // unique in the window; also the item name for tests
    chart::Axis x = {.label = "time", .unit = "s"};  // the unit is shown at the ticks and at the crosshair
    chart::Panel panel = {};                         // y axis, its title in the upper left, and curves
    bool x_labels = true;                            // labels below; false if the plot below shows them
    std::optional<double> cursor = {};               // x of a vertical line that can be dragged; empty: none
    bool legend = false;                             // drawn at the upper right
    bool selectable = false;                         // Shift and left drag select a range of x
    bool editable = false;                           // the left button is left to the panel that draws over the plot
    bool held = false;  // editable plots only: an element over the plot is being dragged, so left drags do not pan
};

/// The x axis that several plots share, such as the time axis of x, y and z. Owned by the panel.
struct LinkedAxis {
    std::optional<chart::Range> range;   // visible range; empty = all data
    std::optional<chart::Range> chosen;  // selected by the user, evaluated separately; empty: none
};

/// Interaction state of one plot between frames. Owned by the panel; a default value resets zoom and drags.
struct PlotState {
    std::optional<chart::Range> y;      // visible range; empty = all data
    std::optional<ImVec2> box_start;    // first corner of a zoom box in progress [pixels in the window]
    std::optional<double> chosen_from;  // first end of an x selection in progress
    bool dragging_cursor = false;       // with the left button
    bool panning = false;               // with the middle button, also outside the plot
};

/// Names of the curves that the user has switched off in the legend. Shared by all plots of a panel.
using HiddenSeries = std::set<std::string>;

/// Drawing area of a plot and the scales of its axes. Used by tests and by panels that draw over a plot.
struct PlotArea {
    platform::Rectangle pixels;  // in the window
    chart::Scale x;              // between values and pixels of the window
    chart::Scale y;
};

/// What happened to a plot in this frame.
struct PlotResult {
    PlotArea area;
    std::optional<double> cursor;  // new x of the cursor line, if the user moved it
    bool hovered = false;          // the mouse is over the plot, with no other item in front
    bool active = false;           // a mouse button that was pressed over the plot is still down
};

/// Distance between a plot's left edge and its drawing area [pixels]. The same for all plots, so that plots below each
/// other align.
float plot_margin_left(const platform::Theme& theme);

/// Draws a plot of the given size [pixels] at ImGui's cursor and handles the mouse.
///
/// Wheel: zooms x about the mouse, with Shift y. Left drag: pans, or moves the cursor line if it was grabbed. Click:
/// places the cursor line. Middle drag: pans. Right drag: zooms to a box. Shift and left drag in a selectable plot:
/// selects a range of x; Shift and click clears it. Double click: shows all data. An editable plot ignores left clicks
/// and double clicks.
///
/// @param x_axis  visible x range, shared with linked plots; changed by zooming and panning
/// @param state  of this plot between frames
/// @param hidden  curves that are not drawn; changed by clicks in the legend
/// @return the drawing area, and the cursor if the user moved it. An area smaller than 20 x 10 pixels draws nothing.
PlotResult draw_plot(const Plot& plot, const ImVec2& size, const platform::Theme& theme,
                     platform::ItemRectangles& items, LinkedAxis& x_axis, PlotState& state, HiddenSeries& hidden);

/// The visible part of a plot as a chart, for export: ranges as drawn, hidden curves left out.
chart::Chart seen_chart(const Plot& plot, const PlotArea& area, const HiddenSeries& hidden);

/// Index of the sample whose x is nearest to `value`. x is ascending. Empty if there are no samples.
std::optional<std::size_t> nearest_sample(const std::vector<double>& x, double value);

}  // namespace myo::ui::plot
