#include <cmath>

#include "effect/effect.hpp"
#include "effect/signal_response.hpp"

namespace myo::effect {
namespace actuation_lag_parts {

constexpr const char* tau_s = "time_constant_s";

/// tau x' = u - x, integrated exactly for u linear between samples. x is continuous across jumps of u.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const double tau = number(parameters, tau_s);
    if (!(tau > 0.0)) return;
    respond_to_signals(
        context, parameters, moves,
        [tau](const std::vector<double>& times, const std::vector<double>& u) {
            std::vector<double> x{u.front()};
            for (std::size_t k = 1; k < u.size(); ++k) {
                // A jump has h = 0: decay = ramp = 1 leave x unchanged.
                const double h = times[k] - times[k - 1];
                // Weights of the old state and of the input at both ends of the interval; their sum is 1.
                const double decay = std::exp(-h / tau), ramp = h > 0.0 ? tau * (1.0 - decay) / h : 1.0;
                x.push_back(decay * x.back() + (1.0 - ramp) * u[k] + (ramp - decay) * u[k - 1]);
            }
            return x;
        },
        affected);
}

/// Several time constants, because the response is strongly nonlinear in tau.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    std::vector<EffectProbe> list;
    if (any_signal(moves, search))
        for (const double tau : {0.005, 0.05, 0.3}) list.push_back(probe({{tau_s, tau}}, tau_s));
    return list;
}

}  // namespace actuation_lag_parts

Effect actuation_lag() {
    using namespace actuation_lag_parts;
    return {.id = "actuation_lag",
            .kind = EffectKind::actuation,
            .summary = "the actuator follows its signal with a first-order lag",
            .parameters = {fitted_number(tau_s, 0.0, 100.0, 0.02, true), signal_parameter()},
            .apply = apply,
            .probes = probes,
            .draw = {.needs = {.muscles = true}, .amount = tau_s, .lowest = 5e-3, .highest = 0.3}};
}

}  // namespace myo::effect
