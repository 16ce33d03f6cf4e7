#include "panels/material_panel.hpp"

#include <algorithm>

#include <imgui.h>

#include "panels/preview_rows.hpp"
#include "panels/setting_rows.hpp"

namespace myo::ui::panels {
namespace {

/// Limits are in SI units, the smallest step of a drag is in the shown unit; see NumberField.
const std::vector<SettingField>& material_fields() {
    // Equations and their sources: assets/manual/theory.md.
    static const std::vector<SettingField> fields{
        {{"Young's modulus E", "model/youngs_modulus", commands::Dimension::pressure, "kPa",
          "Young's modulus E [Pa]: stress over strain in small tension. With Poisson's ratio it gives the shear "
          "modulus "
          "μ = E / (2 (1 + ν)) and the bulk modulus "
          "κ = E / (3 (1 − 2ν)).",
          commands::youngs_modulus_limits, 0.1, "Young's modulus"},
         &commands::Settings::youngs_modulus_Pa},
        {{"Poisson's ratio ν", "model/poissons_ratio", commands::Dimension::ratio, "",
          "Poisson's ratio ν, dimensionless: transverse contraction of a bar in tension, ν = −ε_across / ε_along. "
          "Silicone "
          "is nearly incompressible, ν ≈ 0.49 to "
          "0.499. Lamé's λ = E ν / ((1 + ν) (1 − 2ν)).",
          commands::poissons_ratio_limits, 1e-4, "Poisson's ratio"},
         &commands::Settings::poissons_ratio},
        {{"Density ρ", "model/density", commands::Dimension::density, "kg/m³",
          "Density ρ [kg/m³] at rest. The mass matrix M in M dv/dt = f is ρ times the integrals of the shape "
          "functions' products, m = ρ V in all.",
          commands::density_limits, 1.0, "density"},
         &commands::Settings::density_kg_m3},
        {{"Damping time τ", "model/damping", commands::Dimension::time, "ms",
          "Kelvin–Voigt time τ [s]: stress S = 2 τ μ dev(dE/dt), E Green's strain. A vibration of angular frequency ω "
          "has the damping ratio ζ = c τ ω / 2: c = 1 in shear and torsion, 2 (1 + ν) / 3 in slender stretching and "
          "bending, 2 (1 − ν + ν²) / (3 (1 − ν)) in wide plates.",
          commands::damping_limits, 0.01, "Kelvin–Voigt time"},
         &commands::Settings::damping_s}};
    return fields;
}

}  // namespace

void MaterialPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    setting_choice(context, "Material", "model/material",
                   "Energy per rest volume ψ [J/m³] of the deformation gradient F; the stress is P = ∂ψ/∂F.",
                   state.materials, &commands::Settings::material);
    draw_law_numbers(context);
    setting_rows(context, material_fields(), edit_);
    draw_preview_rows(context, preview_edit_);
}

void MaterialPanel::draw_law_numbers(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const auto law = std::find_if(state.materials.begin(), state.materials.end(),
                                  [&](const commands::Choice& c) { return c.id == state.settings.material; });
    if (law == state.materials.end()) return;
    for (const commands::ChoiceNumber& number : law->numbers) {
        commands::Settings settings = state.settings;
        // A number that the settings lack has its usual value; it is written with the first edit only.
        double& value = settings.law.try_emplace(number.key, number.usual).first->second;
        const NumberField field{
            number.label, "model/" + number.key, commands::dimension_of_unit(number.unit), number.unit,
            number.tip,   number.limits};
        bool continues = false;
        if (number_row(context, field, edit_, value, continues))
            context.emit(commands::ChangeSettings{settings, field.name, continues});
    }
}

}  // namespace myo::ui::panels
