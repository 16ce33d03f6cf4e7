#include "effect/effect.hpp"

namespace myo::effect {
namespace extra_damping_parts {

constexpr const char* excess = "excess_damping_s";

/// Adds to the Kelvin-Voigt damping time.
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    affected.model.damping_s += number(parameters, excess);
}

/// Not separable from the damping if that is fitted.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    if (search.damping_is_fitted) return {};
    // The response is linear in a small damping time.
    return {probe({{excess, 2e-4}}, excess)};
}

}  // namespace extra_damping_parts

Effect extra_damping() {
    using namespace extra_damping_parts;
    return {.id = "extra_damping",
            .kind = EffectKind::material,
            .summary = "more Kelvin-Voigt damping than the declared value",
            .parameters = {fitted_number(excess, 0.0, 10.0, 2e-3, true)},
            .apply = apply,
            .probes = probes,
            .draw = {.needs = {.known_damping = true}, .amount = excess, .lowest = 2e-4, .highest = 0.03}};
}

}  // namespace myo::effect
