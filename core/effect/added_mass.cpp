#include "effect/effect.hpp"
#include "model/directional_mass.hpp"
#include "model/loaded_face.hpp"

namespace myo::effect {
namespace added_mass_parts {

constexpr const char* density = "surface_density_kg_m2";

/// Directional mass along the normals of the free surface: inertia without weight.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    affected.model.directional_masses.push_back(
        model::added_mass(*context.body, model::free_faces(*context.body), number(parameters, density)));
}

/// One small value: the response is linear in a small mass.
std::vector<EffectProbe> probes(const EffectSearch&) { return {probe({{density, 0.2}}, density)}; }

}  // namespace added_mass_parts

Effect added_mass() {
    using namespace added_mass_parts;
    return {.id = "added_mass",
            .kind = EffectKind::force,
            .summary = "a fluid goes with the surface along its normal: inertia, no weight",
            .parameters = {fitted_number(density, 0.0, 1e4, 1.0, true)},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = density, .lowest = 0.3, .highest = 60.0}};
}

}  // namespace myo::effect
