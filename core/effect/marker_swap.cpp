#include "effect/effect.hpp"
#include "effect/markers_by_name.hpp"

namespace myo::effect {
namespace marker_swap_parts {

void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const auto& names = std::get<std::vector<std::string>>(parameters.at("markers"));
    const int first = marker_number(context, names[0]), second = marker_number(context, names[1]);
    if (first < 0 || second < 0) return;  // fixed markers are not compared
    affected.observation_error.swaps.push_back(
        {static_cast<std::size_t>(first), static_cast<std::size_t>(second), number(parameters, "time_s")});
}

}  // namespace marker_swap_parts

Effect marker_swap() {
    using namespace marker_swap_parts;
    return {"marker_swap",
            EffectKind::measurement,
            "two markers exchange their names from some time on",
            {{"markers", EffectParameterKind::marker_pair},
             {"time_s", EffectParameterKind::number},
             {"trial", EffectParameterKind::trial, true}},
            apply,
            nullptr};
}

}  // namespace myo::effect
