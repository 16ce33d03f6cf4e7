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

/// One curve; x ascending, NaN in y leaves a gap.
struct PlotSeries {
    std::string name;
    Eigen::VectorXd x;
    Eigen::VectorXd y;
    ImVec4 color;
    bool dots = false;  // dots at the samples instead of a line
};

/// What a plot shows this frame.
struct Plot {
    std::string id;
    std::string title;         // upper left, with unit: "x [mm]"
    std::string x_unit = "s";  // for the values at the mouse
    std::string y_unit = "mm";
    bool x_axis = true;  // labels below; false when the plot below shows them
    std::vector<PlotSeries> series;
    std::optional<double> cursor;  // vertical line that can be dragged
    std::optional<double> mark;    // vertical line that stays, as the start of motion
    bool legend = false;
    bool zero_line = false;        // y = 0 drawn, and always inside the range
    std::optional<Range> y_least;  // always inside the range
    bool selectable = false;       // Shift and left drag choose a range of x
    bool editable = false;         // clicks are for whoever draws over it
    bool held = false;             // of an editable one: what is drawn over it is being dragged, so that the plot stays
};

/// The x range of plots that belong together; empty = all data.
struct LinkedAxis {
    std::optional<Range> range;
    std::optional<Range> chosen;  // by the person, to be judged by itself
};

/// What the person did to one plot.
struct PlotState {
    std::optional<Range> y;             // empty = all data
    std::optional<ImVec2> box_start;    // corner of a box being drawn [pixels]
    std::optional<double> chosen_from;  // where a range of x being chosen began
    bool dragging_cursor = false;
    bool panning = false;  // with the middle button
};

/// Shared by all plots of a panel: names switched off in the legend.
using HiddenSeries = std::set<std::string>;

/// Pixels and data of the drawing area, for tests and for what is drawn over it.
struct PlotArea {
    platform::Rectangle pixels;
    Range x;
    Range y;
};

struct PlotResult {
    PlotArea area;
    std::optional<double> cursor;  // where it was dragged to
    bool hovered = false;          // by the mouse, with nothing over it
    bool active = false;           // a button is down that went down over it
};

/// Space between a plot's left edge and its drawing area [pixels]: equal for all, so that linked plots align.
float plot_margin_left(const platform::Theme& theme);

/// Draws a plot of the given size at ImGui's cursor and reacts to the mouse.
///
/// Wheel: zoom in x about the mouse (with Shift in y); left drag: pan, or move the cursor line when it is grabbed;
/// click: cursor goes there; middle drag: pan; right drag: zoom to a box; Shift and left drag in a selectable one: a
/// range of x (Shift and click: none); double click: all data again. Clicks do nothing in an editable one.
PlotResult draw_plot(const Plot& plot, const ImVec2& size, const platform::Theme& theme,
                     platform::ItemRectangles& items, LinkedAxis& x_axis, PlotState& state, HiddenSeries& hidden);

}  // namespace myo::ui::plot
