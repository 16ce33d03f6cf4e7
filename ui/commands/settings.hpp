#pragma once

#include <map>
#include <string>
#include <vector>

#include "commands/declaration.hpp"
#include "commands/muscle.hpp"
#include "commands/switched_off.hpp"
#include "effect/effect_declaration.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::ui::commands {

/// An effect that the user added to the experiment's model.
struct AddedEffect {
    effect::EffectDeclaration declaration;  // id and values, SI
    std::string name;                       // "Quadratic drag"
    std::string value;                      // as shown: "coefficient 903 ± 12 kg/m³"
    bool off = false;                       // runs leave it out

    bool operator==(const AddedEffect&) const = default;
};

/// All values that the user can set before a run, in SI units. Part of the project file and of undo.
struct Settings {
    mesh::CellType element = mesh::CellType::hex8;
    double resolution_m = 0.005;        // target edge length of the elements
    std::string material;               // id in WorkbenchState::materials
    std::map<std::string, double> law;  // parameters of laws by their keys; a missing one has its usual value
    double youngs_modulus_Pa = 2.6e5;   // in small strains
    double poissons_ratio = 0.49;
    double density_kg_m3 = 1070.0;
    double damping_s = 0.0;             // Kelvin-Voigt time
    std::string integrator;             // id in WorkbenchState::integrators
    double spectral_radius = 0.5;       // at infinite frequency, for time schemes in which it can be chosen
    double time_step_s = 0.01;          // of the time scheme
    bool own_step = false;              // the user set time_step_s; otherwise runs adapt it to the vibration
    double velocity_force_1_s = 0.0;    // Lambda of f = Lambda M v
    std::vector<AddedEffect> effects;   // in addition to those that the experiment declares
    std::vector<Muscle> muscles;        // with unique names
    Declaration declaration = {};       // of an experiment: support, gravity, loads, trials, unknown values
    std::vector<SwitchedOff> off = {};  // declared effects that runs leave out

    bool operator==(const Settings&) const = default;
};

/// Whether two settings lead to the same mesh.
inline bool same_mesh(const Settings& a, const Settings& b) {
    return a.element == b.element && a.resolution_m == b.resolution_m &&
           a.declaration.mesh_words == b.declaration.mesh_words;
}

/// Ranges that the workbench allows for the settings, SI units. The backend may still reject a value.
struct Limits {
    double lowest;
    double highest;
};
// In the unit that the setting's name carries: Pa, dimensionless, kg/m³, s, s, dimensionless, 1/s, Hz, Pa,
// dimensionless.
inline constexpr Limits youngs_modulus_limits{1e2, 1e9};
inline constexpr Limits poissons_ratio_limits{0.01, 0.4999};
inline constexpr Limits density_limits{10.0, 2e4};
inline constexpr Limits damping_limits{0.0, 1.0};
inline constexpr Limits time_step_limits{1e-5, 0.1};
inline constexpr Limits spectral_radius_limits{0.0, 1.0};
inline constexpr Limits velocity_force_limits{-100.0, 100.0};
inline constexpr Limits damping_frequency_limits{0.01, 1000.0};  // not part of the settings
inline constexpr Limits muscle_stiffness_limits{1.0, 1e9};
inline constexpr Limits muscle_ratio_limits{-10.0, 10.0};

/// Returns the settings with every number limited to its range.
Settings within_limits(Settings settings);

}  // namespace myo::ui::commands
