#include "plot/plot.hpp"

#include <algorithm>
#include <cmath>

#include "plot/plot_frame.hpp"

namespace myo::ui::plot {
namespace {

double wide(float v) { return static_cast<double>(v); }

/// Data coordinates of a pixel. Pixels grow downwards and values upwards, so y swaps the ends of the drawing area.
double x_at(const PlotArea& area, float pixel) {
    return from_pixel(area.x, wide(pixel), wide(area.pixels.lowest.x), wide(area.pixels.highest.x));
}
double y_at(const PlotArea& area, float pixel) {
    return from_pixel(area.y, wide(pixel), wide(area.pixels.highest.y), wide(area.pixels.lowest.y));
}

/// The x range of all curves together, hidden ones included, so that hiding a curve does not move the time axis.
Range all_x(const Plot& plot) {
    std::vector<const double*> starts;
    std::vector<long> counts;
    for (const PlotSeries& s : plot.series) {
        starts.push_back(s.x.data());
        counts.push_back(s.x.size());
    }
    return padded(range_of(starts, counts), 0.0);
}

/// The y range of the visible curves, of the zero line and of y_least, with a margin of 8 % on each side.
Range all_y(const Plot& plot, const HiddenSeries& hidden) {
    std::vector<const double*> starts;
    std::vector<long> counts;
    static const double zero = 0.0;
    // The arrays of a series are read in place; copying long traces in each frame would be slow.
    for (const PlotSeries& s : plot.series) {
        if (hidden.count(s.name) > 0) continue;
        starts.push_back(s.y.data());
        counts.push_back(s.y.size());
    }
    if (plot.zero_line) {
        starts.push_back(&zero);
        counts.push_back(1);
    }
    if (plot.y_least) {
        for (const double* const end : {&plot.y_least->lowest, &plot.y_least->highest}) {
            starts.push_back(end);
            counts.push_back(1);
        }
    }
    return padded(range_of(starts, counts), 0.08);
}

void react_to_zoom(const PlotArea& area, LinkedAxis& x_axis, PlotState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel == 0.0f) return;
    // 0.85 per notch: a factor, so that zooming in and out by the same number of notches returns to the same range.
    const double factor = std::pow(0.85, wide(io.MouseWheel));
    if (io.KeyShift) {
        state.y = zoomed(area.y, y_at(area, io.MousePos.y), factor);
    } else {
        const Range range = zoomed(area.x, x_at(area, io.MousePos.x), factor);
        // Below this span the labels on the axis would no longer differ.
        if (range.span() > 1e-9 * std::max(1.0, std::abs(range.highest))) x_axis.range = range;
    }
}

void react_to_pan(const PlotArea& area, LinkedAxis& x_axis, PlotState& state) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (moved.x == 0.0f && moved.y == 0.0f) return;
    // The data move with the mouse: the visible range shifts by the same distance in the opposite direction.
    const double dx = wide(moved.x) / wide(area.pixels.width()) * area.x.span();
    const double dy = wide(moved.y) / wide(area.pixels.height()) * area.y.span();
    x_axis.range = Range{area.x.lowest - dx, area.x.highest - dx};
    state.y = Range{area.y.lowest + dy, area.y.highest + dy};
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
        x_axis.range = Range{x_at(area, lowest.x), x_at(area, highest.x)};
        state.y = Range{y_at(area, highest.y), y_at(area, lowest.y)};
    }
    // Released: the box is applied or dropped, and the next press starts a new one.
    state.box_start.reset();
}

/// Updates the selected x range while the left button is held with Shift.
void react_to_choice(const PlotArea& area, LinkedAxis& x_axis, PlotState& state) {
    const double x = std::clamp(x_at(area, ImGui::GetIO().MousePos.x), area.x.lowest, area.x.highest);
    const Range range{std::min(*state.chosen_from, x), std::max(*state.chosen_from, x)};
    // A click without a drag clears the selection.
    x_axis.chosen = range.span() * wide(area.pixels.width()) > 4.0 * area.x.span() ? std::optional(range)
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
        const float at = static_cast<float>(
            to_pixel(area.x, *plot.cursor, wide(area.pixels.lowest.x), wide(area.pixels.highest.x)));
        state.dragging_cursor = std::abs(at - mouse.x) <= grab_width;
    }
    const auto clamped_x = [&] { return std::clamp(x_at(area, mouse.x), area.x.lowest, area.x.highest); };
    if (active && state.dragging_cursor) return clamped_x();
    const bool far = dragged_left();
    if (active && far) react_to_pan(area, x_axis, state);
    if (ImGui::IsItemDeactivated()) {
        const bool was_drag = state.dragging_cursor || far;
        state.dragging_cursor = false;
        if (!was_drag && plot.cursor) return clamped_x();
    }
    return std::nullopt;
}

}  // namespace

float plot_margin_left(const platform::Theme& theme) { return 52.0f * theme.scale; }

PlotResult draw_plot(const Plot& plot, const ImVec2& size, const platform::Theme& theme,
                     platform::ItemRectangles& items, LinkedAxis& x_axis, PlotState& state, HiddenSeries& hidden) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = theme.small->FontSize;
    const bool heading = plot.legend || !plot.title.empty();
    const float top = heading ? line + 8.0f * theme.scale : 4.0f * theme.scale;
    const float bottom = plot.x_axis ? line + 6.0f * theme.scale : 4.0f * theme.scale;
    PlotResult result;
    PlotArea& area = result.area;
    area.pixels = {{at.x + plot_margin_left(theme), at.y + top},
                   {at.x + size.x - 8.0f * theme.scale, at.y + size.y - bottom}};
    // Too small for any label: keep the layout, draw nothing.
    if (area.pixels.width() < 20.0f || area.pixels.height() < 10.0f) {
        ImGui::Dummy(size);
        return result;
    }
    area.x = x_axis.range ? *x_axis.range : all_x(plot);
    area.y = state.y ? *state.y : all_y(plot, hidden);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_plot_frame(list, plot, area, theme);
    list.AddText(theme.small, line, {at.x + 8.0f * theme.scale, at.y + 3.0f * theme.scale},
                 platform::packed(theme.text), plot.title.c_str());
    ImGui::PushClipRect(area.pixels.lowest, area.pixels.highest, true);
    const auto vertical = [&](double x, ImU32 color, float width) {
        const float p = static_cast<float>(
            to_pixel(area.x, x, wide(area.pixels.lowest.x), wide(area.pixels.highest.x)));
        list.AddLine({p, area.pixels.lowest.y}, {p, area.pixels.highest.y}, color, width);
        return p;
    };
    if (plot.selectable && x_axis.chosen) {
        const float from = vertical(x_axis.chosen->lowest, platform::packed(theme.accent, 0.7f), 1.0f);
        const float to = vertical(x_axis.chosen->highest, platform::packed(theme.accent, 0.7f), 1.0f);
        list.AddRectFilled({from, area.pixels.lowest.y}, {to, area.pixels.highest.y},
                           platform::packed(theme.accent, 0.14f));
        items.add(plot.id + "/chosen", {{from, area.pixels.lowest.y}, {to, area.pixels.highest.y}});
    }
    if (plot.mark) vertical(*plot.mark, platform::packed(theme.muted, 0.8f), 1.0f);
    for (const PlotSeries& series : plot.series) {
        if (hidden.count(series.name) == 0) draw_plot_series(list, series, area, theme);
    }
    if (plot.cursor) {
        const float p = vertical(*plot.cursor, platform::packed(theme.accent), 1.5f * theme.scale);
        items.add(plot.id + "/cursor", {{p - 3.0f, area.pixels.lowest.y}, {p + 3.0f, area.pixels.highest.y}});
    }
    ImGui::PopClipRect();

    // One invisible button over the drawing area receives the mouse, so that ImGui gives it to no other item meanwhile.
    ImGui::SetCursorScreenPos(area.pixels.lowest);
    ImGui::InvisibleButton(plot.id.c_str(), {area.pixels.width(), area.pixels.height()});
    items.mark(plot.id);
    const bool hovered = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    result.hovered = hovered;
    result.active = active;
    // The crosshair of an editable plot stays, but its left button belongs to the panel that draws over it.
    if (!plot.editable)
        result.cursor = react_to_left_button(plot, area, active, 6.0f * theme.scale, x_axis, state);
    else if (active && !plot.held && dragged_left())
        react_to_pan(area, x_axis, state);
    react_to_middle_button(area, hovered, x_axis, state);
    react_to_box(list, area, theme, hovered, x_axis, state);
    if (hovered) {
        react_to_zoom(area, x_axis, state);
        if (!plot.editable && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            x_axis.range.reset();
            state.y.reset();
        }
        if (!active && !state.box_start) draw_plot_crosshair(list, plot, area, theme, hidden);
    }
    if (plot.legend) draw_plot_legend(list, plot, area, theme, items, hidden);
    // The plot counts as one item of the given size, whatever was drawn.
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy(size);
    return result;
}

}  // namespace myo::ui::plot
