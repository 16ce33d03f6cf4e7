#include "material/strain_stiffening.hpp"

#include "effect/effect.hpp"

namespace myo::effect {
namespace strain_stiffening_parts {

constexpr const char* c2 = "yeoh_c2";

/// Adds the second term of the Yeoh law to the material.
/// Energy mu/2 c2 (I1 - 3)^2, see material::strain_stiffening().
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    affected.model.material = material::strain_stiffening(affected.model.material, number(parameters, c2));
}

/// One small value: the energy is linear in c2.
std::vector<EffectProbe> probes(const EffectSearch&) { return {probe({{c2, 0.05}}, c2)}; }

}  // namespace strain_stiffening_parts

Effect strain_stiffening_effect() {
    using namespace strain_stiffening_parts;
    return {.id = "strain_stiffening",
            .kind = EffectKind::material,
            .summary = "the material stiffens with strain (Yeoh's second term)",
            .parameters = {fitted_number(c2, -0.2, 1e3, 0.5)},
            .apply = apply,
            .probes = probes,
            .varies_within_cells = true,
            .draw = {.amount = c2, .lowest = 0.05, .highest = 60.0}};
}

}  // namespace myo::effect
