#include "panels/model_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <numbers>

#include "platform/fonts.hpp"
#include "plot/ticks.hpp"

namespace myo {
namespace {

struct SettingField {
    NumberField field;
    double Settings::* value;
};

const std::vector<SettingField>& material_fields() {
    static const std::vector<SettingField> fields{
        {{"E", "model/youngs_modulus", "kPa", "Young's modulus E. Shear modulus \xce\xbc = E / (2 (1 + \xce\xbd)), bulk modulus E / (3 (1 \xe2\x88\x92 2\xce\xbd)).",
          1e3, youngs_modulus_limits, 0.1}, &Settings::youngs_modulus_Pa},
        {{"\xce\xbd", "model/poissons_ratio", "", "Poisson's ratio \xce\xbd; silicone is nearly incompressible, \xce\xbd \xe2\x89\x88 0.49 to 0.499.",
          1.0, poissons_ratio_limits, 1e-4}, &Settings::poissons_ratio},
        {{"\xcf\x81", "model/density", "kg/m\xc2\xb3", "Density \xcf\x81.", 1.0, density_limits, 1.0}, &Settings::density_kg_m3},
        {{"Damping \xcf\x84", "model/damping", "ms", "Kelvin\xe2\x80\x93Voigt time \xcf\x84: stress S = 2 \xcf\x84 \xce\xbc dev(dE/dt). A vibration of angular "
          "frequency \xcf\x89 has the damping ratio \xce\xb6 = \xcf\x84 \xcf\x89 / 2.", 1e-3, damping_limits, 0.01}, &Settings::damping_s}};
    return fields;
}

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

std::string ModelPanel::title() const { return std::string(icon::sliders) + "  Model"; }

void ModelPanel::draw(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const auto numbers = [&](const std::vector<SettingField>& fields) {
        for (const SettingField& entry : fields) {
            Settings settings = state.settings;
            bool goes_on = false;
            if (number_row(context, entry.field, edit_, settings.*entry.value, goes_on)) {
                context.emit(command::ChangeSettings{settings, entry.field.name, goes_on});
            }
        }
    };
    const auto choose = [&](const char* label, const char* name, const char* tip, const std::vector<Choice>& choices,
                            std::string Settings::* id) {
        Settings settings = state.settings;
        if (choice_row(context, label, name, tip, choices, settings.*id)) {
            context.emit(command::ChangeSettings{settings, name, false});
        }
    };
    choose("Material", "model/material", "Elastic energy.", state.materials, &Settings::material);
    numbers(material_fields());
    ImGui::Spacing();
    choose("Time scheme", "model/integrator", "How the equations of motion are stepped in time.", state.integrators, &Settings::integrator);
    const Choice* scheme = state.integrator();
    if (scheme && scheme->has_spectral_radius) numbers(radius_fields());
    numbers(time_fields());
    draw_numerical_damping(context);
    draw_effects(context);
}

void ModelPanel::draw_effects(PanelContext& context) {
    const WorkbenchState& state = context.state;
    if (state.settings.effects.empty()) return;
    ImGui::Spacing();
    for (std::size_t i = 0; i < state.settings.effects.size(); ++i) {
        const AddedEffect& effect = state.settings.effects[i];
        ImGui::PushID(static_cast<int>(i));
        const float button = ImGui::GetFrameHeight();
        row_label(context.theme, effect.name, "An effect that was added to the experiment's own model.");
        const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
        ImGui::PushTextWrapPos(right - button - ImGui::GetStyle().ItemSpacing.x);
        ImGui::TextUnformatted(effect.value.c_str());
        ImGui::PopTextWrapPos();
        context.items.mark("model/effect/" + effect.id);
        ImGui::SameLine();
        ImGui::SetCursorPosX(right - button);
        if (ImGui::Button(icon::remove, {button, 0.0f})) {
            Settings settings = state.settings;
            settings.effects.erase(settings.effects.begin() + static_cast<std::ptrdiff_t>(i));
            context.emit(command::ChangeSettings{settings, "effects", false});
        }
        context.items.mark("model/remove/" + effect.id);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Take it out of the model");
        ImGui::PopID();
    }
}

void ModelPanel::draw_numerical_damping(PanelContext& context) {
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
