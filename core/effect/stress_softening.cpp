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
        // A scale far below the energies softens everything at once, one far above hardly anything: three regimes.
        for (const double part : {0.03, 0.3, 1.5})
            list.push_back(probe({{damage, 0.1}, {scale, part * search.largest_energy_density_J_m3}}, damage));
    return list;
}

/// Energy scale of the order of the energy stored in a body bent by its own weight.
EffectParameters drawn(const DrawContext& context, RandomStream& random) {
    const double strain = context.density_kg_m3 * 9.81 * context.length_m * context.length_m * 3.0 /
                          (context.thickness_m * context.youngs_modulus_Pa);
    return {{scale, random.log_uniform(0.1, 0.6) * context.youngs_modulus_Pa * strain * strain}};
}

}  // namespace stress_softening_parts

Effect stress_softening() {
    using namespace stress_softening_parts;
    // The upper bound of the damage keeps a positive stiffness.
    return {.id = "stress_softening",
            .kind = EffectKind::material,
            .summary = "the stress softens with the largest energy that a point has seen",
            .parameters = {fitted_number(damage, 0.0, 0.98, 0.1), fitted_number(scale, 1e-3, 1e7, 10.0, true)},
            .apply = apply,
            .probes = probes,
            .varies_within_cells = true,
            .draw = {.amount = damage, .lowest = 0.03, .highest = 0.8, .others = drawn}};
}

}  // namespace myo::effect
