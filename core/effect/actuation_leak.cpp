#include <cmath>

#include "effect/effect.hpp"
#include "effect/signal_response.hpp"

namespace myo::effect {
namespace actuation_leak_parts {

constexpr const char* tau_s = "time_constant_s";

/// x' = u' - x / tau, x(0) = u(0), integrated exactly for u linear between samples; x jumps with u.
///
/// The input held before the start has not leaked: the trial begins as declared, and the leak begins at t = 0, for
/// constant signals as well.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const double tau = number(parameters, tau_s);
    respond_to_signals(
        context, parameters, acts,
        [tau](const std::vector<double>& times, const std::vector<double>& u) {
            std::vector<double> x{u.front()};
            for (std::size_t k = 1; k < u.size(); ++k) {
                const double h = times[k] - times[k - 1];
                // A jump has h = 0: decay = kept = 1 pass it on in full.
                const double decay = std::exp(-h / tau), kept = h > 0.0 ? tau / h * (1.0 - decay) : 1.0;
                x.push_back(decay * x.back() + (u[k] - u[k - 1]) * kept);
            }
            return x;
        },
        affected);
}

/// The effect vanishes for tau -> infinity: the probe amount is reciprocal.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    std::vector<EffectProbe> list;
    if (any_signal(acts, search))
        for (const double tau : {20.0, 1.0}) list.push_back({{{{tau_s, tau}}}, tau_s, true, nullptr});
    return list;
}

}  // namespace actuation_leak_parts

Effect actuation_leak() {
    using namespace actuation_leak_parts;
    return {.id = "actuation_leak",
            .kind = EffectKind::actuation,
            .summary = "a held actuation bleeds off",
            .parameters = {fitted_number(tau_s, 1e-3, 1e5, 0.1, true), signal_parameter()},
            .apply = apply,
            .probes = probes,
            .draw = {.needs = {.muscles = true}, .amount = tau_s, .lowest = 0.1, .highest = 30.0, .grows = false}};
}

}  // namespace myo::effect
