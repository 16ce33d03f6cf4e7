#include "panels/knot_editor.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "chart/ticks.hpp"
#include "commands/knot_grid.hpp"
#include "commands/signal_shapes.hpp"
#include "panels/escape.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Sizes of knots [pixels at scale 1] and steps of their values.
struct KnotPolicy {
    float reach = 9.0f;         // within which the mouse takes a knot
    float still = 2.0f;         // moved less, a press is a click
    float radius = 4.5f;        // of a knot
    float held_radius = 6.0f;   // of the one that is chosen or dragged
    double snap_steps = 40.0;   // round values over an axis, about
    double longest_s = 3600.0;  // largest time of a knot
    float menu_width = 300.0f;
};
constexpr KnotPolicy knot_policy;

/// A time [s] and a value [SI] of a knot.
struct KnotPlace {
    double time_s = 0.0;
    double value = 0.0;
    bool limited = false;  // the mouse is beyond a limit
};

/// Pixel of a knot in the window.
ImVec2 pixel_of(const plot::PlotArea& area, const KnotCurve& curve, std::size_t knot) {
    return {static_cast<float>(area.x(curve.signal.times_s[knot])),
            static_cast<float>(area.y(curve.signal.values[knot] / curve.per_unit))};
}

/// Step of an axis to which the mouse is rounded: one that is worth reading, or about a pixel.
double step_of(const chart::Scale& scale, bool snaps) {
    const double pixels = std::abs(scale.to_px - scale.from_px);
    return chart::round_step((scale.highest - scale.lowest) / (snaps ? knot_policy.snap_steps : pixels));
}

/// SI value of a shown one. A unit below the SI unit divides, so that round values stay round.
double si_of(double shown, double per_unit) {
    return per_unit < 1.0 ? shown / std::round(1.0 / per_unit) : shown * per_unit;
}

KnotPlace place_at(const plot::PlotArea& area, const KnotCurve& curve, const ImVec2& pixel, bool snaps) {
    const double time_s = commands::on_grid(area.x.value(static_cast<double>(pixel.x)), step_of(area.x, snaps));
    const double value = si_of(commands::on_grid(area.y.value(static_cast<double>(pixel.y)), step_of(area.y, snaps)),
                               curve.per_unit);
    KnotPlace place{std::clamp(time_s, -knot_policy.longest_s, knot_policy.longest_s),
                    std::clamp(value, curve.limits.lowest, curve.limits.highest)};
    place.limited = place.value != value;
    return place;
}

/// Time and value of a dragged knot, beside the mouse.
void show_place(const PanelContext& context, const KnotCurve& curve, std::size_t knot, bool limited) {
    const std::string value = plot::plain_label(curve.signal.values[knot] / curve.per_unit, 4) +
                              (curve.unit.empty() ? "" : " " + curve.unit);
    const std::string time = plot::plain_label(curve.signal.times_s[knot], 4) + " s";
    ImGui::BeginTooltip();
    ImGui::PushFont(context.theme.small);
    ImGui::TextUnformatted((curve.name + "  " + value + " at " + time).c_str());
    if (limited) ImGui::TextColored(context.theme.warning, "at its limit");
    ImGui::PopFont();
    ImGui::EndTooltip();
}

/// The curve that is drawn nearest above or below the mouse; none of those without further knots.
std::optional<std::size_t> curve_at(const plot::PlotArea& area, const std::vector<KnotCurve>& curves,
                                    const ImVec2& mouse) {
    std::optional<std::size_t> nearest;
    double least = std::numeric_limits<double>::infinity();
    const double time_s = area.x.value(static_cast<double>(mouse.x));
    for (std::size_t c = 0; c < curves.size(); ++c) {
        if (curves[c].constant) continue;
        const double apart = std::abs(area.y(curves[c].signal.value(time_s) / curves[c].per_unit) -
                                      static_cast<double>(mouse.y));
        if (apart < least) least = apart, nearest = c;
    }
    return nearest;
}

}  // namespace

void KnotEditor::forget() {
    grabbed_.reset();
    chosen_.reset();
    menu_.reset();
}

void KnotEditor::snap_button(PanelContext& context) {
    if (tab(context.theme, "Snap", snap_)) snap_ = !snap_;
    context.items.mark("signals/snap");
    tooltip(context.theme,
            "Dragged knots go to round times and values. Ctrl does the opposite while it is held.\n\nA double click "
            "adds a knot; Delete removes the one that was clicked last; a right click on a knot shows its numbers.");
}

const KnotCurve* KnotEditor::curve_of(const Knot& knot, const std::vector<KnotCurve>& curves) {
    const auto found = std::find_if(curves.begin(), curves.end(),
                                    [&](const KnotCurve& curve) { return curve.name == knot.curve; });
    return found != curves.end() && knot.index < found->signal.times_s.size() ? &*found : nullptr;
}

std::optional<KnotEditor::Knot> KnotEditor::knot_at(const plot::PlotArea& area, const std::vector<KnotCurve>& curves,
                                                    float within) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::optional<Knot> nearest;
    for (const KnotCurve& curve : curves)
        for (std::size_t k = 0; k < curve.signal.times_s.size(); ++k) {
            const ImVec2 p = pixel_of(area, curve, k);
            const float distance = std::hypot(p.x - mouse.x, p.y - mouse.y);
            if (distance < within) within = distance, nearest = Knot{curve.name, k};
        }
    return nearest;
}

void KnotEditor::draw(PanelContext& context, const plot::PlotArea& area, const std::vector<KnotCurve>& curves) const {
    const platform::Theme& theme = context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // Slightly larger than the drawing area, so that knots at its edge are complete.
    const float edge = knot_policy.held_radius * theme.scale;
    ImGui::PushClipRect({area.pixels.lowest.x - edge, area.pixels.lowest.y - edge},
                        {area.pixels.highest.x + edge, area.pixels.highest.y + edge}, true);
    for (const KnotCurve& curve : curves)
        for (std::size_t k = 0; k < curve.signal.times_s.size(); ++k) {
            const ImVec2 p = pixel_of(area, curve, k);
            const bool held = chosen_ == Knot{curve.name, k};
            const float radius = (held ? knot_policy.held_radius : knot_policy.radius) * theme.scale;
            list.AddCircleFilled(p, radius, platform::packed(held ? theme.accent : theme.background), 20);
            list.AddCircle(p, radius, platform::packed(curve.color), 20, 1.6f * theme.scale);
            context.items.add(curve.item + "/" + std::to_string(k),
                              {{p.x - 4.0f, p.y - 4.0f}, {p.x + 4.0f, p.y + 4.0f}});
        }
    ImGui::PopClipRect();
}

void KnotEditor::press(const KnotPlot& plot, const KnotCurve& curve, const Knot& knot) {
    const plot::PlotArea& area = plot.drawn.area;
    const ImVec2 mouse = ImGui::GetIO().MousePos, at = pixel_of(area, curve, knot.index);
    grabbed_ = Drag{knot, {at.x - mouse.x, at.y - mouse.y}, false, plot.x_axis.range, plot.state.y};
    // Axes that follow the data would run away from under the mouse.
    plot.x_axis.range = area.x.range();
    plot.state.y = area.y.range();
}

std::optional<KnotEdit> KnotEditor::drag(PanelContext& context, const KnotPlot& plot,
                                         const std::vector<KnotCurve>& curves) {
    const KnotCurve* const curve = curve_of(grabbed_->knot, curves);
    // Another plot of the panel has it, or undo has removed it.
    if (!curve && ImGui::IsMouseDown(ImGuiMouseButton_Left)) return std::nullopt;
    if (!curve || !plot.drawn.active) {
        plot.x_axis.range = grabbed_->x;
        if (curve) plot.state.y = grabbed_->y;
        grabbed_.reset();
        return std::nullopt;
    }
    const ImGuiIO& io = ImGui::GetIO();
    const float still = knot_policy.still * context.theme.scale;
    const bool still_a_click = !grabbed_->moved && io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < still * still;
    const KnotPlace to = place_at(plot.drawn.area, *curve,
                                  {io.MousePos.x + grabbed_->offset.x, io.MousePos.y + grabbed_->offset.y}, snaps());
    show_place(context, *curve, grabbed_->knot.index, !still_a_click && to.limited);
    if (still_a_click) return std::nullopt;
    KnotEdit edit{static_cast<std::size_t>(curve - curves.data()),
                  commands::with_knot_moved(curve->signal, grabbed_->knot.index, to.time_s, to.value), grabbed_->moved};
    if (edit.signal == curve->signal) return std::nullopt;
    grabbed_->moved = true;
    return edit;
}

std::optional<KnotEdit> KnotEditor::add_or_remove(PanelContext& context, const KnotPlot& plot,
                                                  const std::vector<KnotCurve>& curves) {
    const auto edit_of = [&](std::size_t index, fibre::Signal signal) -> std::optional<KnotEdit> {
        if (signal == curves[index].signal) return std::nullopt;
        return KnotEdit{index, std::move(signal), false};
    };
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (plot.drawn.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        const auto index = curve_at(plot.drawn.area, curves, mouse);
        if (!index) return std::nullopt;
        const KnotPlace at = place_at(plot.drawn.area, curves[*index], mouse, snaps());
        chosen_.reset();
        return edit_of(*index, commands::with_knot_added(curves[*index].signal, at.time_s, at.value));
    }
    // A tool of the view that places markers or guides has the key meanwhile.
    if (!chosen_ || context.placing.on() || !ImGui::IsWindowFocused() || ImGui::GetIO().WantTextInput ||
        keys_belong_to_popup() || !ImGui::IsKeyPressed(ImGuiKey_Delete, false))
        return std::nullopt;
    const KnotCurve* const curve = curve_of(*chosen_, curves);
    if (!curve) return std::nullopt;
    const std::size_t knot = chosen_->index;
    chosen_.reset();
    return edit_of(static_cast<std::size_t>(curve - curves.data()), commands::with_knot_removed(curve->signal, knot));
}

std::optional<KnotEdit> KnotEditor::menu(PanelContext& context, const std::vector<KnotCurve>& curves) {
    const KnotCurve* const curve = menu_ ? curve_of(*menu_, curves) : nullptr;
    if (!curve) return std::nullopt;
    ImGui::SetNextWindowSize({knot_policy.menu_width * context.theme.scale, 0.0f});
    if (!ImGui::BeginPopup("knot")) {
        menu_.reset();
        return std::nullopt;
    }
    if (escape_closes()) ImGui::CloseCurrentPopup();
    KnotEdit edit{static_cast<std::size_t>(curve - curves.data()), curve->signal};
    double time_s = curve->signal.times_s[menu_->index], value = curve->signal.values[menu_->index];
    const double longest = knot_policy.longest_s;
    bool changed = number_row(context,
                              {"Time",
                               "signals/menu/time",
                               commands::Dimension::time,
                               "s",
                               "Time of the trial [s]. A knot stays between its neighbours.",
                               {-longest, longest},
                               0.005},
                              edits_, time_s, edit.goes_on, curve->name);
    changed = number_row(context,
                         {curve->quantity, "signals/menu/value", curve->dimension, curve->unit,
                          "Value at this time; linear between the knots.", curve->limits, 0.005},
                         edits_, value, edit.goes_on, curve->name) ||
              changed;
    if (changed) edit.signal = commands::with_knot_moved(curve->signal, menu_->index, time_s, value);
    ImGui::BeginDisabled(curve->signal.times_s.size() < 2);
    if (ImGui::Button("Remove the knot", {-1.0f, 0.0f})) {
        edit.signal = commands::with_knot_removed(curve->signal, menu_->index);
        chosen_.reset();
        ImGui::CloseCurrentPopup();
    }
    context.items.mark("signals/menu/remove");
    ImGui::EndDisabled();
    ImGui::EndPopup();
    return edit.signal == curve->signal ? std::nullopt : std::optional(edit);
}

std::optional<KnotEdit> KnotEditor::edit(PanelContext& context, const KnotPlot& plot,
                                         const std::vector<KnotCurve>& curves) {
    const plot::PlotArea& area = plot.drawn.area;
    if (area.pixels.width() < 20.0f || area.pixels.height() < 10.0f) return std::nullopt;
    draw(context, area, curves);
    if (grabbed_) return drag(context, plot, curves);
    const auto near = plot.drawn.hovered ? knot_at(area, curves, knot_policy.reach * context.theme.scale)
                                         : std::nullopt;
    if (near && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        press(plot, *curve_of(*near, curves), *near);
        chosen_ = near;
        return std::nullopt;
    }
    // A click; a drag with the right button is a zoom to a box.
    if (near && ImGui::IsMouseReleased(ImGuiMouseButton_Right) &&
        ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Right] < 16.0f) {
        menu_ = chosen_ = near;
        ImGui::OpenPopup("knot");
    }
    if (auto changed = menu(context, curves)) return changed;
    return add_or_remove(context, plot, curves);
}

}  // namespace myo::ui::panels
