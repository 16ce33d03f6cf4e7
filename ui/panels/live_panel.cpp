#include "panels/live_panel.hpp"

#include <imgui.h>

#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Stiffnesses of the spring that can be typed [N/m].
constexpr commands::Limits spring_limits_N_m{1e-3, 1e6};

}  // namespace

void LivePanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    draw_buttons(context);
    if (!state.live) {
        muted_text(context.theme,
                   "Moves the model in real time: drag the body to pull it, move its actuators. The recorded run "
                   "stays.");
        return;
    }
    notice_in_place(context.theme, commands::LogLevel::warning, state.live->problem, 2);
    if (!state.live->problem.empty()) context.items.mark("live/problem");
    // Levels and spring are known once the model is made.
    if (!state.live->ready) return;
    draw_levels(context);
    draw_spring(context);
    text_row(context.theme, "Step", plot::value_label(1e3 * state.live->frame->step_s, 3) + " ms");
    text_row(context.theme, "Speed",
             state.live->rate > 0.0 ? plot::value_label(state.live->rate, 2) + "\xc3\x97 real time" : "\xe2\x80\x93");
    context.items.mark("live/rate");
}

void LivePanel::draw_buttons(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - spacing);
    const bool on = state.live.has_value();
    // The model that plays is that of the present settings, so it needs their mesh. Stopping is always possible.
    ImGui::BeginDisabled(!on && !state.mesh_is_current());
    const std::string label = std::string(on ? platform::icon::stop : platform::icon::hand) +
                              (on ? "  Stop" : "  Play live");
    if (ImGui::Button((label + "###play").c_str(), {width, 0.0f})) context.emit(commands::PlayLive{!on});
    context.items.mark("live/play");
    ImGui::EndDisabled();
    tooltip(context.theme, on                        ? "Back to the recorded run."
                           : state.mesh_is_current() ? "The model moves in real time, from the start of the trial."
                                                     : "Build the mesh first.");
    ImGui::SameLine();
    ImGui::BeginDisabled(!on);
    if (ImGui::Button((std::string(platform::icon::to_start) + "  To the start").c_str(), {width, 0.0f}))
        context.emit(commands::RestartLive{});
    context.items.mark("live/restart");
    ImGui::EndDisabled();
}

void LivePanel::draw_levels(PanelContext& context) {
    const commands::LiveView& live = *context.state.live;
    for (std::size_t i = 0; i < live.actuators.size() && i < live.controls.levels.size(); ++i) {
        const commands::LiveActuator& actuator = live.actuators[i];
        NumberField field;
        field.label = actuator.name;
        field.name = "live/level/" + actuator.name;
        field.dimension = actuator.unit == "kPa"  ? commands::Dimension::pressure
                          : actuator.unit == "N"  ? commands::Dimension::force
                          : actuator.unit == "mm" ? commands::Dimension::length
                                                  : commands::Dimension::number;
        field.unit = actuator.unit;
        field.tip = actuator.quantity + ", acts at once.";
        field.quantity = actuator.quantity;
        field.limits = {actuator.lowest, actuator.highest};
        // A drag over at most 1000 pixels covers the range.
        field.smallest_step = 1e-3 * (actuator.highest - actuator.lowest) / actuator.per_unit;
        double level = live.controls.levels[i];
        bool goes_on = false;
        bool changed = number_row(context, field, edits_, level, goes_on);
        // Number and slider show the same level; the one that was moved decides.
        double shown = level / actuator.per_unit;
        if (slider_row(context, field.name + "/slider",
                       {actuator.lowest / actuator.per_unit, actuator.highest / actuator.per_unit}, false, slide_,
                       shown, goes_on)) {
            level = shown * actuator.per_unit;
            changed = true;
        }
        if (!changed) continue;
        commands::LiveControls controls = live.controls;
        controls.levels[i] = level;
        context.emit(commands::SteerLive{controls});
    }
}

void LivePanel::draw_spring(PanelContext& context) {
    NumberField field;
    field.label = "Spring of the mouse";
    field.name = "live/spring";
    field.dimension = commands::Dimension::stiffness;
    field.unit = "N/m";
    field.tip = "Stiffness of the spring between the mouse and the point of the body that it holds.";
    field.limits = spring_limits_N_m;
    field.smallest_step = 0.1;
    double spring = context.state.live->controls.spring_N_m;
    bool goes_on = false;
    if (!number_row(context, field, edits_, spring, goes_on)) return;
    commands::LiveControls controls = context.state.live->controls;
    controls.spring_N_m = spring;
    context.emit(commands::SteerLive{controls});
}

}  // namespace myo::ui::panels
