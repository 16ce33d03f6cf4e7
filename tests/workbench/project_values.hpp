#pragma once

#include <string>

#include "commands/project.hpp"
#include "support/value_lines.hpp"

namespace myo::test {

/// Numbers and words of a project as read from its file, without the folder of its source.
inline ValueLines project_values(const ui::commands::Project& project) {
    ValueLines lines;
    lines.add("source", project.source.filename().string());
    if (project.metres_per_unit) lines.add("metres_per_unit", *project.metres_per_unit);
    lines.add("trial", project.trial);
    const ui::commands::Settings& s = project.settings;
    lines.add("mesh.element", std::string(to_string(s.element)));
    lines.add("mesh.resolution_m", s.resolution_m);
    lines.add("material.model", s.material);
    lines.add("material.youngs_modulus_Pa", s.youngs_modulus_Pa);
    lines.add("material.poissons_ratio", s.poissons_ratio);
    lines.add("material.density_kg_m3", s.density_kg_m3);
    lines.add("material.damping_s", s.damping_s);
    lines.add("time.integrator", s.integrator);
    lines.add("time.step_s", s.time_step_s);
    lines.add("time.spectral_radius", s.spectral_radius);
    lines.add("time.velocity_force_1_s", s.velocity_force_1_s);
    for (const ui::commands::AddedEffect& effect : s.effects) {
        const std::string key = "effect." + effect.declaration.id;
        lines.add(key + ".name", effect.name);
        lines.add(key + ".value", effect.value);
        for (const auto& [name, value] : effect.declaration.parameters) lines.add(key + "." + name, value);
    }
    for (const ui::commands::Muscle& m : s.muscles) {
        const std::string key = "muscle." + m.name;
        lines.add(key + ".declared", m.declared);
        lines.add(key + ".color", m.color);
        lines.add(key + ".stiffness_Pa", m.stiffness_Pa);
        lines.add(key + ".extends", m.extends);
        lines.add(key + ".follows", m.follows);
        if (!m.follows.empty()) lines.add(key + ".ratio", m.ratio);
        if (m.signal) lines.add(key + ".signal.time_s", m.signal->times_s);
        if (m.signal) lines.add(key + ".signal.a", m.signal->values);
        if (!m.paint) continue;
        lines.add(key + ".mask.cell_size_m", m.paint->cell_size_m);
        lines.add(key + ".mask.centroids_m", m.paint->centroids_m);
        lines.add(key + ".mask.weights", m.paint->weights);
        lines.add(key + ".mask.directions", m.paint->directions);
    }
    const ui::commands::ViewOptions& v = project.view;
    const std::vector<double> shown{1.0 * v.edges,  1.0 * v.grid,        1.0 * v.measured, 1.0 * v.simulated,
                                    1.0 * v.trails, 1.0 * v.errors,      1.0 * v.labels,   1.0 * v.clamp,
                                    1.0 * v.fibres, 1.0 * v.effect_force};
    lines.add("view.shown", shown);
    lines.add("view.opacity", v.opacity);
    lines.add("view.field", v.field);
    lines.add("view.color_map", v.color_map);
    for (const auto& [field, range] : v.field_ranges)
        lines.add("view.field_ranges." + field, std::vector<double>{range[0], range[1]});
    lines.add("view.cut.on", v.clip.on);
    lines.add("view.cut.normal", v.clip.normal);
    lines.add("view.cut.position_m", v.clip.position_m);
    lines.add("view.cut.flip", v.clip.flip);
    return lines;
}

}  // namespace myo::test
