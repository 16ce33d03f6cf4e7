#include "effect/effect.hpp"

namespace myo::effect {
namespace frame_rate_error_parts {

constexpr const char* error = "relative_error";

/// True rate = declared rate times (1 + error).
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    affected.observation_error.rate_error += number(parameters, error);
}

/// Two sizes: the response to a large error is not linear.
std::vector<EffectProbe> probes(const EffectSearch&) {
    return {probe({{error, 0.002}}, error), probe({{error, 0.02}}, error)};
}

}  // namespace frame_rate_error_parts

Effect frame_rate_error() {
    using namespace frame_rate_error_parts;
    return {.id = "frame_rate_error",
            .kind = EffectKind::measurement,
            .summary = "the cameras' true rate differs from the declared one",
            .parameters = {fitted_number(error, -0.5, 2.0, 0.02)},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = error, .lowest = 5e-4, .highest = 0.08, .has_sign = true}};
}

}  // namespace myo::effect
