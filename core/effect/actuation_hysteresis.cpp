#include <algorithm>
#include <cmath>

#include "effect/effect.hpp"
#include "effect/signal_response.hpp"

namespace myo::effect {
namespace actuation_hysteresis_parts {

/// Bouc-Wen model without smoothing: (1 - h) u + h z with z' = u' (1 - [u' z > 0] |z| / width).
///
/// Within a sample interval the equation for z is linear, and its exponential solution is exact. z is 0 at u = 0 and
/// has followed u from there to its value before the start: a constant input is not reached in full.
/// Source: Bouc 1967, Wen 1976; with the exponent 1.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const double h = number(parameters, "fraction"), width = number(parameters, "width");
    // z after the input has changed by du.
    const auto moved = [width](double z, double du) {
        if (du == 0.0) return z;
        const double direction = du > 0.0 ? 1.0 : -1.0;
        double left = std::abs(du);
        if (direction * z < 0.0) {  // unloading to zero: unit slope
            const double straight = std::min(left, std::abs(z));
            z += direction * straight;
            left -= straight;
        }
        // Loading branch: exponential approach to direction * width.
        return z + (left > 0.0 ? (direction * width - z) * (1.0 - std::exp(-left / width)) : 0.0);
    };
    respond_to_signals(
        context, parameters, acts,
        [=](const std::vector<double>&, const std::vector<double>& u) {
            // The path before the trial is not known: taken as monotonous from rest to the first value.
            double z = moved(0.0, u.front());
            std::vector<double> x{(1.0 - h) * u.front() + h * z};
            for (std::size_t k = 1; k < u.size(); ++k) {
                z = moved(z, u[k] - u[k - 1]);
                x.push_back((1.0 - h) * u[k] + h * z);
            }
            return x;
        },
        affected);
}

/// The width is relative to the largest input: hysteresis that saturates early, and one that does not.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const double largest = largest_input(search);
    std::vector<EffectProbe> list;
    if (any_signal(acts, search))
        for (const double part : {0.1, 0.5})
            list.push_back(probe({{"fraction", 0.1}, {"width", part * largest}}, "fraction"));
    return list;
}

/// Width in units of the activation of a muscle.
EffectParameters drawn(const DrawContext&, RandomStream& random) { return {{"width", random.log_uniform(0.02, 0.12)}}; }

/// The width is an input, and has the unit of the signal.
EffectParameterEntry width_parameter() {
    EffectParameterEntry width = fitted_number("width", 1e-4, 10.0, 0.05, true);
    width.of_signal = true;
    return width;
}

}  // namespace actuation_hysteresis_parts

Effect actuation_hysteresis() {
    using namespace actuation_hysteresis_parts;
    return {
        .id = "actuation_hysteresis",
        .kind = EffectKind::actuation,
        .summary = "the actuator's way back differs from its way there (Bouc-Wen)",
        .parameters = {fitted_number("fraction", 0.0, 1.0, 0.2), width_parameter(), signal_parameter()},
        .apply = apply,
        .probes = probes,
        .draw = {.needs = {.muscles = true}, .amount = "fraction", .lowest = 0.05, .highest = 0.9, .others = drawn}};
}

}  // namespace myo::effect
