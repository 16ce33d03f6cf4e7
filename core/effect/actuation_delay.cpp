#include <algorithm>

#include "effect/bends_between_steps.hpp"
#include "effect/effect.hpp"
#include "effect/signal_response.hpp"

namespace myo::effect {
namespace actuation_delay_parts {

constexpr const char* delay_s = "delay_s";

/// a(t) -> a(t - delay), smoothed so that the run depends smoothly on the delay.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const double delay = number(parameters, delay_s);
    if (!(delay > 0.0)) return;
    change_signals(context, parameters, affected.model, [&](fibre::Signal& signal, double) {
        if (signal.times_s.size() < 2) return;
        // The value at the start extends to all earlier times; the motion of the file begins at t = 0.
        for (double& time : signal.times_s) time += delay;
        // A kink that moves within a step would change the impulse of the stages by more than the delay.
        signal = with_bends_between_steps(signal, affected.options.h_s, affected.options.end_s);
    });
}

/// Two orders of magnitude, because the response of a long delay is not proportional to that of a short one.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    std::vector<EffectProbe> list;
    if (any_signal(moves, search))
        for (const double delay : {0.004, 0.04}) list.push_back(probe({{delay_s, delay}}, delay_s));
    return list;
}

}  // namespace actuation_delay_parts

Effect actuation_delay() {
    using namespace actuation_delay_parts;
    return {.id = "actuation_delay",
            .kind = EffectKind::actuation,
            .summary = "the actuator follows its signal after a dead time",
            .parameters = {fitted_number(delay_s, 0.0, 100.0, 0.02, true), signal_parameter()},
            .apply = apply,
            .probes = probes,
            .draw = {.needs = {.muscles = true}, .amount = delay_s, .lowest = 5e-3, .highest = 0.2}};
}

}  // namespace myo::effect
