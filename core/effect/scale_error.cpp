#include "effect/effect.hpp"

namespace myo::effect {
namespace scale_error_parts {

constexpr const char* error = "relative_error";

/// Recorded coordinates times 1 + error, about the mesh origin.
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    affected.observation_error.scale_error += number(parameters, error);
}

/// One small value: the recording is linear in the error.
std::vector<EffectProbe> probes(const EffectSearch&) { return {probe({{error, 0.002}}, error)}; }

}  // namespace scale_error_parts

Effect scale_error() {
    using namespace scale_error_parts;
    return {.id = "scale_error",
            .kind = EffectKind::measurement,
            .summary = "all coordinates are off by a factor about the origin",
            .parameters = {fitted_number(error, -0.5, 2.0, 0.01)},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = error, .lowest = 1e-3, .highest = 0.05, .has_sign = true}};
}

}  // namespace myo::effect
