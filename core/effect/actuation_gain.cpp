#include "effect/effect.hpp"
#include "effect/signal_response.hpp"

namespace myo::effect {
namespace actuation_gain_parts {

constexpr const char* change = "relative_change";

/// a - 1 -> (1 + change) (a - 1): the passive state a = 1 stays.
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    const double factor = 1.0 + number(parameters, change);
    for (fibre::Signal& signal : affected.model.activation)
        for (double& value : signal.values) value = 1.0 + factor * (value - 1.0);
}

/// Observable only if some muscle leaves its passive state.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    for (const model::Model& model : search.models)
        for (const fibre::Signal& signal : model.activation)
            for (const double value : signal.values)
                if (value != 1.0) return {probe({{change, 0.02}}, change)};
    return {};
}

}  // namespace actuation_gain_parts

// A relative change of -1 would be no actuation at all: the lower bound.
Effect actuation_gain() {
    using namespace actuation_gain_parts;
    return {.id = "actuation_gain",
            .kind = EffectKind::actuation,
            .summary = "the muscle moves by a constant factor more than its signal",
            .parameters = {fitted_number(change, -1.0, 20.0, 0.2)},
            .apply = apply,
            .probes = probes,
            .draw = {.needs = {.muscles = true}, .amount = change, .lowest = 0.02, .highest = 0.5, .has_sign = true}};
}

}  // namespace myo::effect
