#include "plot/plot.hpp"

#include <algorithm>
#include <cmath>

#include "plot/draw_chart.hpp"
#include "plot/legend.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::plot {
namespace {

/// ImGui computes in float, charts in double.
double wide(float v) { return static_cast<double>(v); }

/// Values at a pixel.
double x_at(const PlotArea& area, float pixel) { return area.x.value(wide(pixel)); }
double y_at(const PlotArea& area, float pixel) { return area.y.value(wide(pixel)); }

/// The visible range after the curves moved by `pixels`.
chart::Range moved(const chart::Scale& scale, float pixels) {
    return scale.range(scale.from_px - wide(pixels), scale.to_px - wide(pixels));
}

/// The visible range scaled by `factor` about a pixel. A factor below 1 zooms in.
chart::Range zoomed(const chart::Scale& scale, float pixel, double factor) {
    const double fixed = wide(pixel);
    return scale.range(fixed + factor * (scale.from_px - fixed), fixed + factor * (scale.to_px - fixed));
}

/// Wheel: zooms x about the mouse, with Shift y.
void react_to_zoom(const PlotArea& area, LinkedAxis& x_axis, PlotState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel == 0.0f) return;
    // 0.85 per notch: a factor, so that zooming in and out by the same number of notches returns to the same range.
    const double factor = std::pow(0.85, wide(io.MouseWheel));
    if (io.KeyShift) {
        state.y = zoomed(area.y, io.MousePos.y, factor);
    } else {
        const chart::Range range = zoomed(area.x, io.MousePos.x, factor);
        // Below this span the labels on the axis would no longer differ.
        if (range.span() > 1e-9 * std::max(1.0, std::abs(range.highest))) x_axis.range = range;
    }
}

/// Moves both ranges with the mouse.
void react_to_pan(const PlotArea& area, LinkedAxis& x_axis, PlotState& state) {
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    if (by.x == 0.0f && by.y == 0.0f) return;
    x_axis.range = moved(area.x, by.x);
    state.y = moved(area.y, by.y);
}

/// The middle button pans also in an editable plot, where the left button edits. Panning goes on outside the plot until
/// the button is released.
void react_to_middle_button(const PlotArea& area, bool hovered, LinkedAxis& x_axis, PlotState& state) {
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) state.panning = true;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Middle)) state.panning = false;
    if (state.panning) react_to_pan(area, x_axis, state);
}

/// Rubber-band zoom with the right button: a press over the plot stores the corner, a release applies the box. Boxes of
/// 4 pixels or less are treated as clicks, which do nothing here.
void react_to_box(ImDrawList& list, const PlotArea& area, const platform::Theme& theme, bool hovered,
                  LinkedAxis& x_axis, PlotState& state) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) state.box_start = mouse;
    if (!state.box_start) return;
    const ImVec2 lowest{std::min(state.box_start->x, mouse.x), std::min(state.box_start->y, mouse.y)};
    const ImVec2 highest{std::max(state.box_start->x, mouse.x), std::max(state.box_start->y, mouse.y)};
    list.AddRectFilled(lowest, highest, platform::packed(theme.accent, 0.18f));
    list.AddRect(lowest, highest, platform::packed(theme.accent));
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) return;
    if (highest.x - lowest.x > 4.0f && highest.y - lowest.y > 4.0f) {
        x_axis.range = chart::Range{x_at(area, lowest.x), x_at(area, highest.x)};
        state.y = chart::Range{y_at(area, highest.y), y_at(area, lowest.y)};
    }
    // Released: the box is applied or dropped, and the next press starts a new one.
    state.box_start.reset();
}

/// Updates the selected x range while the left button is held with Shift.
void react_to_choice(const PlotArea& area, LinkedAxis& x_axis, PlotState& state) {
    const double x = std::clamp(x_at(area, ImGui::GetIO().MousePos.x), area.x.lowest, area.x.highest);
    const chart::Range range{std::min(*state.chosen_from, x), std::max(*state.chosen_from, x)};
    // A click without a drag clears the selection.
    x_axis.chosen = range.span() * wide(area.pixels.width()) > 4.0 * area.x.range().span() ? std::optional(range)
                                                                                           : std::nullopt;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) state.chosen_from.reset();
}

/// Whether the left button moved far enough for a drag (4 pixels), so that an unsteady click does not pan.
bool dragged_left() {
    const ImVec2 dragged = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 4.0f);
    return dragged.x != 0.0f || dragged.y != 0.0f;
}

// Handles the left button: selects an x range, drags the cursor line, pans, or places the cursor at a click. Returns
// the new x of the cursor line if it changes.
std::optional<double> react_to_left_button(const Plot& plot, const PlotArea& area, bool active, float grab_width,
                                           LinkedAxis& x_axis, PlotState& state) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemActivated() && plot.selectable && ImGui::GetIO().KeyShift)
        state.chosen_from = std::clamp(x_at(area, mouse.x), area.x.lowest, area.x.highest);
    if (state.chosen_from) {
        react_to_choice(area, x_axis, state);
        return std::nullopt;
    }
    // A press within grab_width pixels of the cursor line grabs the line; any other press pans or clicks.
    if (ImGui::IsItemActivated() && plot.cursor) {
        const auto at = static_cast<float>(area.x(*plot.cursor));
        state.dragging_cursor = std::abs(at - mouse.x) <= grab_width;
    }
    const auto clamped_x = [&] { return std::clamp(x_at(area, mouse.x), area.x.lowest, area.x.highest); };
    if (active && state.dragging_cursor) return clamped_x();
    // A press that trembles is a click, not a drag.
    const bool far = dragged_left();
    if (active && far) react_to_pan(area, x_axis, state);
    // Released: without a drag the click places the cursor line.
    if (ImGui::IsItemDeactivated()) {
        const bool was_drag = state.dragging_cursor || far;
        state.dragging_cursor = false;
        if (!was_drag && plot.cursor) return clamped_x();
    }
    return std::nullopt;
}

/// The plot as a chart, its range that of the zoom if there is one.
chart::Chart chart_in_window(const Plot& plot, const std::optional<chart::Range>& x,
                             const std::optional<chart::Range>& y, const HiddenSeries& hidden) {
    chart::Chart chart{.x = plot.x, .panels = {plot.panel}, .legend = plot.legend, .x_labels = plot.x_labels};
    if (x) chart.x.lowest = x->lowest, chart.x.highest = x->highest;
    chart::Axis& vertical = chart.panels[0].y;
    if (y) vertical.lowest = y->lowest, vertical.highest = y->highest;
    for (chart::Series& series : chart.panels[0].series) series.hidden = hidden.count(series.name) > 0;
    return chart;
}

/// Vertical line at a value, as far as it is visible. Returns its pixel.
float draw_cursor_line(ImDrawList& list, const PlotArea& area, double x, ImU32 color, float width) {
    const auto p = static_cast<float>(area.x(x));
    list.AddLine({p, area.pixels.lowest.y}, {p, area.pixels.highest.y}, color, width);
    return p;
}

/// Selected range and cursor line, over the curves.
void draw_cursor(ImDrawList& list, const Plot& plot, const PlotArea& area, const LinkedAxis& x_axis,
                 const platform::Theme& theme, platform::ItemRectangles& items) {
    const float top = area.pixels.lowest.y, bottom = area.pixels.highest.y;
    list.PushClipRect(area.pixels.lowest, area.pixels.highest, true);
    if (plot.selectable && x_axis.chosen) {
        const ImU32 edge = platform::packed(theme.accent, 0.7f);
        const float from = draw_cursor_line(list, area, x_axis.chosen->lowest, edge, 1.0f);
        const float to = draw_cursor_line(list, area, x_axis.chosen->highest, edge, 1.0f);
        list.AddRectFilled({from, top}, {to, bottom}, platform::packed(theme.accent, 0.14f));
        items.add(plot.id + "/chosen", {{from, top}, {to, bottom}});
    }
    if (plot.cursor) {
        const float p = draw_cursor_line(list, area, *plot.cursor, platform::packed(theme.accent), 1.5f * theme.scale);
        items.add(plot.id + "/cursor", {{p - 3.0f, top}, {p + 3.0f, bottom}});
    }
    list.PopClipRect();
}

/// A click on an entry hides or shows its curve; the entry under the mouse is brighter.
void react_to_legend(ImDrawList& list, const Plot& plot, const std::vector<chart::PlacedEntry>& legend,
                     const platform::Theme& theme, platform::ItemRectangles& items, HiddenSeries& hidden) {
    for (const auto& [entry, at] : legend) {
        const platform::Rectangle box{{static_cast<float>(at.left), static_cast<float>(at.top)},
                                      {static_cast<float>(at.right()), static_cast<float>(at.bottom())}};
        items.add(plot.id + "/legend/" + entry.name, box);
        const bool hovered = ImGui::IsWindowHovered() && box.contains(ImGui::GetIO().MousePos);
        draw_legend_entry(list, entry, box, hovered, hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left), theme,
                          hidden);
    }
}

/// Hair lines at the mouse, and a tooltip with the values of all visible curves at the sample nearest to it.
void draw_crosshair(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme,
                    const HiddenSeries& hidden) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const platform::Rectangle& r = area.pixels;
    const ImU32 color = platform::packed(theme.muted, 0.5f);
    list.AddLine({std::round(mouse.x), r.lowest.y}, {std::round(mouse.x), r.highest.y}, color);
    list.AddLine({r.lowest.x, std::round(mouse.y)}, {r.highest.x, std::round(mouse.y)}, color);
    const double x = x_at(area, mouse.x);
    ImGui::BeginTooltip();
    ImGui::PushFont(theme.small);
    ImGui::Text("%s %s", value_label(x, 4).c_str(), plot.x.unit.c_str());
    // Hidden curves are left out of the tooltip, too.
    for (const chart::Series& series : plot.panel.series) {
        if (hidden.count(series.name) > 0) continue;
        const std::optional<std::size_t> i = nearest_sample(series.x, x);
        if (!i) continue;
        ImGui::TextColored(window_colour(series.own_colour.value_or(chart_colour(theme.text))), "%s  %s %s",
                           series.name.c_str(), value_label(series.y[*i], 4).c_str(), plot.panel.y.unit.c_str());
    }
    ImGui::PopFont();
    ImGui::EndTooltip();
}

/// All reactions to the mouse over the drawing area, which the last item covers.
void react_to_mouse(ImDrawList& list, const Plot& plot, const platform::Theme& theme, LinkedAxis& x_axis,
                    PlotState& state, const HiddenSeries& hidden, PlotResult& result) {
    const PlotArea& area = result.area;
    // The crosshair of an editable plot stays, but its left button belongs to the panel that draws over it.
    if (!plot.editable)
        result.cursor = react_to_left_button(plot, area, result.active, 6.0f * theme.scale, x_axis, state);
    else if (result.active && !plot.held && dragged_left())
        react_to_pan(area, x_axis, state);
    react_to_middle_button(area, result.hovered, x_axis, state);
    react_to_box(list, area, theme, result.hovered, x_axis, state);
    if (!result.hovered) return;
    react_to_zoom(area, x_axis, state);
    if (!plot.editable && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        x_axis.range.reset();
        state.y.reset();
    }
    if (!result.active && !state.box_start) draw_crosshair(list, plot, area, theme, hidden);
}

}  // namespace

chart::Series plot_series(std::string name, const Eigen::VectorXd& x, const Eigen::VectorXd& y, const ImVec4& color,
                          bool dots) {
    const Eigen::Index count = std::min(x.size(), y.size());
    chart::Series series{.name = std::move(name),
                         .x = {x.data(), x.data() + count},
                         .y = {y.data(), y.data() + count},
                         .style = dots ? chart::SeriesStyle::dots : chart::SeriesStyle::line};
    series.own_colour = chart_colour(color);
    return series;
}

std::optional<std::size_t> nearest_sample(const std::vector<double>& x, double value) {
    if (x.empty()) return std::nullopt;
    // The first sample not below `value`; the nearest one is this or the one before.
    auto above = std::lower_bound(x.begin(), x.end(), value);
    if (above == x.end()) return x.size() - 1;
    if (above != x.begin() && value - above[-1] < *above - value) --above;
    return static_cast<std::size_t>(above - x.begin());
}

chart::Chart seen_chart(const Plot& plot, const PlotArea& area, const HiddenSeries& hidden) {
    chart::Chart chart = chart_in_window(plot, area.x.range(), area.y.range(), hidden);
    std::erase_if(chart.panels[0].series, [](const chart::Series& series) { return series.hidden; });
    return chart;
}

float plot_margin_left(const platform::Theme& theme) { return static_cast<float>(window_style(theme).left_margin); }

PlotResult draw_plot(const Plot& plot, const ImVec2& size, const platform::Theme& theme,
                     platform::ItemRectangles& items, LinkedAxis& x_axis, PlotState& state, HiddenSeries& hidden) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const chart::LayoutStyle style = window_style(theme);
    const chart::Palette palette = chart_palette(theme);
    chart::Chart chart = chart_in_window(plot, x_axis.range, state.y, hidden);
    const bool heading = plot.legend || !plot.panel.y.label.empty() || !plot.panel.y.unit.empty();
    chart.width_px = wide(size.x);
    chart.panels[0].height_px = std::max(1.0, wide(size.y) - chart::added_height(style, heading, plot.x_labels));
    const chart::Layout layout = chart::lay_out(chart, style, palette, window_text_width(theme),
                                                {wide(at.x), wide(at.y)});
    const chart::Rectangle& place = layout.panels[0].area;
    PlotResult result;
    result.area = {{{static_cast<float>(place.left), static_cast<float>(place.top)},
                    {static_cast<float>(place.right()), static_cast<float>(place.bottom())}},
                   layout.x.scale,
                   layout.panels[0].y.scale};
    const platform::Rectangle& pixels = result.area.pixels;
    // Too small for any label: keep the layout, draw nothing.
    if (pixels.width() < 20.0f || pixels.height() < 10.0f) {
        ImGui::Dummy(size);
        return result;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // The entries of the legend are drawn by react_to_legend().
    chart::Layout without_legend = layout;
    without_legend.legend.clear();
    draw_chart(list, chart::draw(chart, without_legend, palette), theme);
    draw_cursor(list, plot, result.area, x_axis, theme, items);

    // One invisible button over the drawing area receives the mouse, so that ImGui gives it to no other item meanwhile.
    ImGui::SetCursorScreenPos(pixels.lowest);
    ImGui::InvisibleButton(plot.id.c_str(), {pixels.width(), pixels.height()});
    items.mark(plot.id);
    result.hovered = ImGui::IsItemHovered();
    result.active = ImGui::IsItemActive();
    react_to_mouse(list, plot, theme, x_axis, state, hidden, result);
    react_to_legend(list, plot, layout.legend, theme, items, hidden);
    // The plot counts as one item of the given size, whatever was drawn.
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy(size);
    return result;
}

}  // namespace myo::ui::plot
