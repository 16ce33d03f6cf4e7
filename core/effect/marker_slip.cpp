#include "effect/effect.hpp"
#include "effect/markers_by_name.hpp"

namespace myo::effect {
namespace marker_slip_parts {

/// Markers that are not on the body (fixed ones) are not compared and are ignored.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const int marker = marker_number(context, text(parameters, "marker"));
    if (marker < 0) return;
    affected.observation_error.shifts.push_back(
        {static_cast<std::size_t>(marker), vector(parameters, "shift_m"), number(parameters, "time_s")});
}

}  // namespace marker_slip_parts

Effect marker_slip() {
    using namespace marker_slip_parts;
    return {"marker_slip",
            EffectKind::measurement,
            "a marker moves by a fixed vector at some time",
            {{"marker", EffectParameterKind::marker},
             {"shift_m", EffectParameterKind::vector3, false, -10.0, 10.0, 1e-3},
             {"time_s", EffectParameterKind::number},
             {"trial", EffectParameterKind::trial, true}},
            apply,
            nullptr};
}

}  // namespace myo::effect
