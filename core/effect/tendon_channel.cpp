#include "model/tendon_channel.hpp"

#include <algorithm>
#include <utility>

#include "effect/effect.hpp"

namespace myo::effect {
namespace tendon_channel_parts {

constexpr const char* share = "share";

struct TendonChannelEffectPolicy {
    /// A fifth of the lengthening that a channel would give: the response is linear in the share.
    double probed_share = 0.2;
};
constexpr TendonChannelEffectPolicy tendon_channel_effect_policy;

/// Divides the legs of all tendons; nodes that the new legs couple become part of the body's pattern.
void apply(const TrialContext&, const EffectParameters& parameters, Affected& affected) {
    model::Model& model = affected.model;
    for (model::ForceElementPointer& element : model.force_elements) {
        const model::TendonRoute* declared = model::tendon_route(*element);
        if (!declared) continue;
        model::TendonRoute route = model::in_channel(*declared, model.body->mesh, number(parameters, share));
        if (route.guides.size() == declared->guides.size()) continue;
        model.body = model::coupled_body(*model.body, route, model::is_driven_by_shortening(*element));
        element = model::with_route(*element, std::move(route));
    }
}

/// Whether a leg is longer than a thread in a channel would be bound at.
bool has_long_leg(const model::ForceElement& element, const mesh::VolumeMesh& mesh) {
    const model::TendonRoute* route = model::tendon_route(element);
    return route && model::in_channel(*route, mesh, 1.0).guides.size() > route->guides.size();
}

/// Observable where a leg may bend with the material.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const model::Model& model = search.models.front();
    const auto long_leg = [&](const model::ForceElementPointer& element) {
        return has_long_leg(*element, model.body->mesh);
    };
    if (std::none_of(model.force_elements.begin(), model.force_elements.end(), long_leg)) return {};
    return {probe({{share, tendon_channel_effect_policy.probed_share}}, share)};
}

}  // namespace tendon_channel_parts

/// Between two guides the thread was declared straight.
Effect tendon_channel() {
    using namespace tendon_channel_parts;
    return {.id = "tendon_channel",
            .kind = EffectKind::force,
            .summary = "threads run in channels: between their guides they bend with the material",
            .parameters = {fitted_number(share, 0.0, 1.0, 0.2, true)},
            .apply = apply,
            .probes = probes,
            .draw = {.needs = {.tendon = true, .far_guides = true}, .amount = share, .lowest = 0.1, .highest = 1.0}};
}

}  // namespace myo::effect
