#pragma once

#include <imgui.h>

#include <Eigen/Core>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "platform/item_rectangles.hpp"
#include "platform/theme.hpp"
#include "plot/ticks.hpp"

namespace myo::ui::plot {

/// One curve of a plot. x is ascending; a NaN in y (or x) interrupts the line. If the lengths differ, the shorter one
/// counts.
struct PlotSeries {
    std::string name;  // in the legend; also identifies the curve in HiddenSeries
    Eigen::VectorXd x;
    Eigen::VectorXd y;
    ImVec4 color;
    bool dots = false;  // dots at the samples instead of a line
};

/// Content of a plot in this frame. A panel builds a new one for each frame; the plot keeps nothing of it.
struct Plot {
    std::string id;             // unique in the window; also the item name for tests
    std::string title;          // upper left, with unit: "x [mm]"
    std::string x_unit = "s";   // unit of x at the crosshair and the ticks
    std::string y_unit = "mm";  // unit of y at the crosshair
    bool x_axis = true;         // tick labels below; false if the plot below shows them
    std::vector<PlotSeries> series;
    std::optional<double> cursor;  // x of a vertical line that can be dragged; empty: none
    std::optional<double> mark;    // x of a fixed vertical line, such as the start of motion; empty: none
    bool legend = false;           // drawn at the upper right
    bool zero_line = false;        // draws y = 0 and keeps it inside the range
    std::optional<Range> y_least;  // range of y that is always visible; empty: follows the data
    bool selectable = false;       // Shift and left drag select a range of x
    bool editable = false;         // the left button is left to the panel that draws over the plot
    bool held = false;  // editable plots only: an element over the plot is being dragged, so left drags do not pan
};

/// The x axis that several plots share, such as the time axis of x, y and z. Owned by the panel.
struct LinkedAxis {
    std::optional<Range> range;   // visible range; empty = all data
    std::optional<Range> chosen;  // selected by the user, evaluated separately; empty: none
};

/// Interaction state of one plot between frames. Owned by the panel; a default value resets zoom and drags.
struct PlotState {
    std::optional<Range> y;             // visible range; empty = all data
    std::optional<ImVec2> box_start;    // first corner of a zoom box in progress [pixels in the window]
    std::optional<double> chosen_from;  // first end of an x selection in progress
    bool dragging_cursor = false;       // with the left button
    bool panning = false;               // with the middle button
};

/// Names of the curves that the user has switched off in the legend. Shared by all plots of a panel.
using HiddenSeries = std::set<std::string>;

/// Drawing area of a plot and the data ranges that it shows. Used by tests and by panels that draw over a plot.
struct PlotArea {
    platform::Rectangle pixels;  // in the window
    Range x;
    Range y;
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

}  // namespace myo::ui::plot
