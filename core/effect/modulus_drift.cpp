#include <algorithm>

#include "effect/effect.hpp"

namespace myo::effect {
namespace modulus_drift_parts {

constexpr const char* rate = "rate_1_s";

/// Moduli times 1 + rate * session time, at least 0.01.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    // One factor per trial: the drift within a trial of seconds is far below that over a session.
    const double factor = std::max(0.01, 1.0 + number(parameters, rate) * context.session_time_s);
    for (material::Moduli& m : affected.model.moduli) m = {factor * m.mu, factor * m.kappa};
}

/// Longest time between trials [s].
double longest_time(const EffectSearch& search) {
    double longest = 0.0;
    for (const TrialContext& context : search.trials)
        longest = std::max(longest, std::abs(context.session_time_s - search.trials.front().session_time_s));
    return longest;
}

/// Observable only with trials at different session times; otherwise a drift equals a change of the modulus.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    if (!(longest_time(search) > 0.0)) return {};
    // 2 % over the session.
    return {probe({{rate, 0.02 / longest_time(search)}}, rate)};
}

}  // namespace modulus_drift_parts

Effect modulus_drift() {
    using namespace modulus_drift_parts;
    return {.id = "modulus_drift",
            .kind = EffectKind::material,
            .summary = "the modulus drifts over the session",
            .parameters = {fitted_number(rate, -1.0, 1.0, 1e-4)},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = rate, .lowest = 1e-5, .highest = 1e-3, .has_sign = true}};
}

}  // namespace myo::effect
