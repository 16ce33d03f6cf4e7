#include "effect/effect.hpp"

namespace myo::effect {
namespace stress_softening_parts {

constexpr const char* damage = "damage_max";
constexpr const char* scale = "energy_scale_J_m3";

/// No damage is the virgin law without memory, and not softening by zero: it costs no state variable.
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    if (number(parameters, damage) > 0.0)
        affected.model.softening = material::StressSoftening{number(parameters, damage), number(parameters, scale)};
}

/// Energy scales relative to the largest energy density of the declared fit.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    std::vector<EffectProbe> list;
    if (search.largest_energy_density_J_m3 > 0.0)
        for (const double part : {0.03, 0.3, 1.5})
            list.push_back(probe({{damage, 0.1}, {scale, part * search.largest_energy_density_J_m3}}, damage));
    return list;
}

}  // namespace stress_softening_parts

Effect stress_softening() {
    using namespace stress_softening_parts;
    // The upper bound of the damage keeps a positive stiffness.
    Effect effect{"stress_softening",
                  EffectKind::material,
                  "the stress softens with the largest energy that a point has seen",
                  {fitted_number(damage, 0.0, 0.98, 0.1), fitted_number(scale, 1e-3, 1e7, 10.0, true)},
                  apply,
                  probes};
    effect.varies_within_cells = true;
    return effect;
}

}  // namespace myo::effect
