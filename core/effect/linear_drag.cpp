#include "effect/effect.hpp"
#include "model/loaded_face.hpp"
#include "model/surface_drag.hpp"

namespace myo::effect {
namespace linear_drag_parts {

constexpr const char* coefficient = "coefficient_Pa_s_m";

/// Traction -c v on the free surface.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    affected.model.force_elements.push_back(
        model::surface_drag(*context.body, model::free_faces(*context.body), number(parameters, coefficient), 0.0));
}

/// One small value: the force is linear in the coefficient.
std::vector<EffectProbe> probes(const EffectSearch&) { return {probe({{coefficient, 5.0}}, coefficient)}; }

}  // namespace linear_drag_parts

Effect linear_drag() {
    using namespace linear_drag_parts;
    return {.id = "linear_drag",
            .kind = EffectKind::force,
            .summary = "drag of a resting fluid in proportion to the speed",
            .parameters = {fitted_number(coefficient, 0.0, 1e5, 20.0, true)},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = coefficient, .lowest = 1.0, .highest = 500.0}};
}

}  // namespace myo::effect
