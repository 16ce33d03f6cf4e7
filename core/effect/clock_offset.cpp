#include "effect/effect.hpp"

namespace myo::effect {
namespace clock_offset_parts {

constexpr const char* offset = "offset_s";

/// Samples stamped t were taken at t + offset.
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    affected.observation_error.clock_offset_s += number(parameters, offset);
}

/// Offsets of a part of a frame and of a few frames.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    std::vector<EffectProbe> list;
    const double interval = search.trials.front().interval_s;
    // Both signs: the response is not smooth at zero, because the body is at rest before the start.
    for (const double frames : {0.3, -0.3, 2.0, -2.0}) list.push_back(probe({{offset, frames * interval}}, offset));
    return list;
}

}  // namespace clock_offset_parts

Effect clock_offset() {
    using namespace clock_offset_parts;
    return {.id = "clock_offset",
            .kind = EffectKind::measurement,
            .summary = "samples were taken later or earlier than stated",
            .parameters = {fitted_number(offset, -10.0, 10.0, 0.01)},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = offset, .lowest = 5e-4, .highest = 0.05, .has_sign = true}};
}

}  // namespace myo::effect
