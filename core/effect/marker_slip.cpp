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

/// A random marker, direction, time and fitted trial.
EffectParameters drawn(const DrawContext& context, RandomStream& random) {
    const int marker = random.below(static_cast<int>(context.marker_names.size()));
    return {{"marker", context.marker_names[static_cast<std::size_t>(marker)]},
            {"shift_m", Eigen::VectorXd(1e-3 * drawn_direction(random))},
            {"time_s", drawn_time_s(context, random)},
            {"trial", drawn_fitted_trial(context, random)}};
}

}  // namespace marker_slip_parts

Effect marker_slip() {
    using namespace marker_slip_parts;
    return {.id = "marker_slip",
            .kind = EffectKind::measurement,
            .summary = "a marker moves by a fixed vector at some time",
            .parameters = {{"marker", EffectParameterKind::marker},
                           {"shift_m", EffectParameterKind::vector3, false, -10.0, 10.0, 1e-3},
                           {"time_s", EffectParameterKind::number},
                           {"trial", EffectParameterKind::trial, true}},
            .apply = apply,
            .marker_event = MarkerEvent::slip,
            .draw = {.amount = "shift_m", .lowest = 5e-4, .highest = 0.02, .others = drawn}};
}

}  // namespace myo::effect
