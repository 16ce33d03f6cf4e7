#include "effect/effect.hpp"
#include "effect/signal_response.hpp"

namespace myo::effect {
namespace actuation_gain_parts {

constexpr const char* change = "relative_change";

/// u -> (1 + change) u, a - 1 of a muscle: the passive state stays.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const double factor = 1.0 + number(parameters, change);
    change_signals(context, parameters, affected.model, [&](fibre::Signal& signal, double passive) {
        for (double& value : signal.values) value = passive + factor * (value - passive);
    });
}

/// Observable only if some actuator leaves its passive state.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    if (!any_signal(acts, search)) return {};
    // The response is linear in a small change, of either sign.
    return {probe({{change, 0.02}}, change)};
}

}  // namespace actuation_gain_parts

// A relative change of -1 is no actuation at all, and the lower bound.
Effect actuation_gain() {
    using namespace actuation_gain_parts;
    return {.id = "actuation_gain",
            .kind = EffectKind::actuation,
            .summary = "the actuator moves by a constant factor more than its signal",
            .parameters = {fitted_number(change, -1.0, 20.0, 0.2), signal_parameter()},
            .apply = apply,
            .probes = probes,
            .draw = {.needs = {.muscles = true}, .amount = change, .lowest = 0.02, .highest = 0.5, .has_sign = true}};
}

}  // namespace myo::effect
