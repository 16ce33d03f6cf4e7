#include "panels/time_panel.hpp"

#include <imgui.h>

#include <numbers>

#include "panels/setting_rows.hpp"
#include "plot/ticks.hpp"

namespace myo {
namespace {

const std::vector<SettingField>& radius_fields() {
    static const std::vector<SettingField> fields{
        {{"\xcf\x81\xe2\x88\x9e", "model/spectral_radius", "", "Part of a very fast vibration that a step leaves: 0 takes it out at once, 1 keeps it.",
          1.0, spectral_radius_limits, 0.01}, &Settings::spectral_radius}};
    return fields;
}

const std::vector<SettingField>& time_fields() {
    static const std::vector<SettingField> fields{
        {{"Step h", "model/time_step", "ms", "Time step h.", 1e-3, time_step_limits, 0.01}, &Settings::time_step_s},
        {{"\xce\x9b", "model/velocity_force", "1/s", "Velocity force f = \xce\x9b M v. A positive \xce\x9b feeds in the energy that a dissipative time "
          "scheme takes out; 0 switches it off.", 1.0, velocity_force_limits, 0.01}, &Settings::velocity_force_1_s}};
    return fields;
}

}  // namespace

void TimePanel::draw(PanelContext& context) {
    const WorkbenchState& state = context.state;
    setting_choice(context, "Time scheme", "model/integrator", "How the equations of motion are stepped in time.", state.integrators, &Settings::integrator);
    const Choice* scheme = state.integrator();
    if (scheme && scheme->has_spectral_radius) setting_rows(context, radius_fields(), edit_);
    setting_rows(context, time_fields(), edit_);
    draw_numerical_damping(context);
}

void TimePanel::draw_numerical_damping(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const Choice* const scheme = state.integrator();
    if (!scheme || !scheme->numerical_damping_ratio) return;
    const double frequency = state.damping_frequency_Hz;
    const double ratio = scheme->numerical_damping_ratio(2.0 * std::numbers::pi * frequency, state.settings);
    row_label(context.theme, "\xce\xb6(h)", "Damping ratio that the time scheme itself adds at this frequency and step. Measured silicone has about 0.05.");
    ImGui::AlignTextToFramePadding();
    // Comparable to a silicone's own damping: it would be calibrated into the material.
    const ImVec4 color = ratio > 0.02 ? context.theme.warning : context.theme.text;
    ImGui::TextColored(color, "%s at", value_label(ratio, 3).c_str());
    context.items.mark("model/numerical_damping");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    double shown = frequency;
    if (ImGui::InputDouble("##frequency", &shown, 0.0, 0.0, "%.4g Hz") && shown > 0.0) {
        context.emit(command::SetDampingFrequency{shown});
    }
    context.items.mark("model/damping_frequency");
}

}  // namespace myo
