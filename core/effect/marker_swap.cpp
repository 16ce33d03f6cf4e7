#include "effect/effect.hpp"
#include "effect/markers_by_name.hpp"

namespace myo::effect {
namespace marker_swap_parts {

/// Exchanges the recorded tracks of two markers from a time on.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const auto& names = std::get<std::vector<std::string>>(parameters.at("markers"));
    const int first = marker_number(context, names[0]), second = marker_number(context, names[1]);
    if (first < 0 || second < 0) return;  // fixed markers are not compared
    affected.observation_error.swaps.push_back(
        {static_cast<std::size_t>(first), static_cast<std::size_t>(second), number(parameters, "time_s")});
}

/// Two different markers.
EffectParameters drawn(const DrawContext& context, RandomStream& random) {
    const int count = static_cast<int>(context.marker_names.size()), first = random.below(count),
              second = (first + 1 + random.below(count - 1)) % count;
    return {{"markers", std::vector<std::string>{context.marker_names[static_cast<std::size_t>(first)],
                                                 context.marker_names[static_cast<std::size_t>(second)]}},
            {"time_s", drawn_time_s(context, random)},
            {"trial", drawn_fitted_trial(context, random)}};
}

}  // namespace marker_swap_parts

Effect marker_swap() {
    using namespace marker_swap_parts;
    // Without an amount: an exchange has no size.
    return {.id = "marker_swap",
            .kind = EffectKind::measurement,
            .summary = "two markers exchange their names from some time on",
            .parameters = {{"markers", EffectParameterKind::marker_pair},
                           {"time_s", EffectParameterKind::number},
                           {"trial", EffectParameterKind::trial, true}},
            .apply = apply,
            .marker_event = MarkerEvent::swap,
            .draw = {.others = drawn}};
}

}  // namespace myo::effect
