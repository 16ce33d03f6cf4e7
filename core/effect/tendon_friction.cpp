#include <utility>

#include "effect/effect.hpp"
#include "model/tendon.hpp"

namespace myo::effect {
namespace tendon_friction_parts {

struct TendonFrictionPolicy {
    double probed_coefficient = 0.05;  // a lubricated thread; its effect is linear in the coefficient
};
constexpr TendonFrictionPolicy tendon_friction_policy;

/// Adds the coefficient to the friction of the tendon that is named, or of all.
void apply(const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
    const std::string only = has(parameters, "tendon") ? text(parameters, "tendon") : "";
    const double added = effect::number(parameters, "coefficient");
    // Actuators are named in the order of their signals: muscles first, then force elements.
    std::size_t number = affected.model.activation.size();
    for (model::ForceElementPointer& element : affected.model.force_elements) {
        if (element->command() == nullptr) continue;
        const std::size_t i = number++;
        if (!only.empty() && (i >= context.actuator_names.size() || context.actuator_names[i] != only)) continue;
        // Chambers have commands, too, but no friction: null for them.
        if (model::ForceElementPointer rubbing = model::with_added_friction(*element, added))
            element = std::move(rubbing);
    }
}

/// Names of the tendons of a model.
/// Chambers are left out: they have no friction to which 0 could be added.
std::vector<std::string> tendons_of(const TrialContext& context, const model::Model& model) {
    std::vector<std::string> names;
    std::size_t number = model.activation.size();
    for (const model::ForceElementPointer& element : model.force_elements) {
        if (element->command() == nullptr) continue;
        const std::size_t i = number++;
        if (i < context.actuator_names.size() && model::with_added_friction(*element, 0.0))
            names.push_back(context.actuator_names[i]);
    }
    return names;
}

/// All tendons together, and each alone if there are several.
std::vector<EffectProbe> probes(const EffectSearch& search) {
    const std::vector<std::string> names = tendons_of(search.trials.front(), search.models.front());
    if (names.empty()) return {};
    const EffectParameters all{{"coefficient", tendon_friction_policy.probed_coefficient}};
    std::vector<EffectProbe> list{probe(all, "coefficient")};
    if (names.size() < 2) return list;
    for (const std::string& name : names) {
        EffectParameters one = all;
        one["tendon"] = name;
        list.push_back(probe(std::move(one), "coefficient"));
    }
    return list;
}

}  // namespace tendon_friction_parts

Effect tendon_friction() {
    using namespace tendon_friction_parts;
    return {.id = "tendon_friction",
            .kind = EffectKind::force,
            .summary = "a tendon rubs at its guides: the tension falls at every bend",
            .parameters = {fitted_number("coefficient", 0.0, 5.0, 0.05, true),
                           {.name = "tendon", .kind = EffectParameterKind::actuator, .optional = true}},
            .apply = apply,
            .probes = probes,
            .has_corner = true,
            .draw = {.needs = {.tendon = true}, .amount = "coefficient", .lowest = 0.01, .highest = 2.0}};
}

}  // namespace myo::effect
