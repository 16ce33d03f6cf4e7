#include "effect/changed_body.hpp"
#include "effect/effect.hpp"
#include "model/elastic_bed.hpp"
#include "model/loaded_face.hpp"

namespace myo::effect {
namespace clamp_compliance_parts {

constexpr const char* bed_stiffness = "stiffness_Pa_per_m";

/// Frees the clamped nodes and supports their faces by distributed springs [Pa/m].
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    std::vector<int> nodes;
    for (int i = 0; i < context.body->node_count(); ++i)
        if (context.body->clamped[static_cast<std::size_t>(i)]) nodes.push_back(i);
    const std::vector<int> faces = model::faces_of_nodes(*context.body, nodes);
    if (faces.empty()) return;  // clamped nodes inside the body have no face for the bed
    affected.model.body = released_body(*affected.model.body, nodes);
    // The faces are those of the declared body: the released one has no clamped nodes.
    affected.model.force_elements.push_back(
        model::elastic_bed(*context.body, faces, number(parameters, bed_stiffness)));
}

/// Rigid clamp = infinite stiffness: the probe amount is reciprocal.
std::vector<EffectProbe> probes(const EffectSearch&) {
    return {{{{{bed_stiffness, 2e8}}}, bed_stiffness, true, nullptr}};
}

}  // namespace clamp_compliance_parts

Effect clamp_compliance() {
    using namespace clamp_compliance_parts;
    return {.id = "clamp_compliance",
            .kind = EffectKind::support,
            .summary = "the clamped face sits on an elastic bed",
            .parameters = {fitted_number(bed_stiffness, 1e4, 1e12, 1e6, true)},
            .apply = apply,
            .probes = probes,
            .draw = {.amount = bed_stiffness, .lowest = 5e5, .highest = 1e9, .grows = false}};
}

}  // namespace myo::effect
