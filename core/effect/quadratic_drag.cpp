#include "effect/effect.hpp"
#include "model/loaded_face.hpp"
#include "model/surface_drag.hpp"

namespace myo::effect {
namespace quadratic_drag_parts {

constexpr const char* coefficient = "coefficient_kg_m3";

/// Traction proportional to the square of the speed on the free surface.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    affected.model.force_elements.push_back(
        model::surface_drag(*context.body, model::free_faces(*context.body), 0.0, number(parameters, coefficient)));
}

/// One small value: the force is linear in the coefficient, though not in the velocity.
std::vector<EffectProbe> probes(const EffectSearch&) { return {probe({{coefficient, 50.0}}, coefficient)}; }

}  // namespace quadratic_drag_parts

Effect quadratic_drag() {
    using namespace quadratic_drag_parts;
    return {.id = "quadratic_drag",
            .kind = EffectKind::force,
            .summary = "drag of a resting fluid that grows with the square of the speed",
            .parameters = {fitted_number(coefficient, 0.0, 1e6, 300.0, true)},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = coefficient, .lowest = 30.0, .highest = 6000.0}};
}

}  // namespace myo::effect
