#include "effect/catalogue.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "effect/effects.hpp"

namespace myo::effect {

// The order defines the order in lists and reports. Tests run over the catalogue, so that a new entry is checked at
// once.
const std::vector<Effect>& effect_catalogue() {
    static const std::vector<Effect> effects = {
        quadratic_drag(),
        linear_drag(),
        added_mass(),
        point_mass(),
        cable_tug(),
        hung_mass(),
        gravity_tilt(),
        clamp_compliance(),
        clamp_slip(),
        held_pose(),
        extra_damping(),
        viscoelastic_creep(),
        strain_stiffening_effect(),
        stress_softening(),
        stiffness_gradient(),
        soft_patch(),
        modulus_drift(),
        intrinsic_curvature(),
        actuation_lag(),
        actuation_delay(),
        actuation_gain(),
        actuation_leak(),
        actuation_hysteresis(),
        clock_offset(),
        frame_rate_error(),
        scale_error(),
        marker_swap(),
        marker_slip(),
    };
    return effects;
}

const Effect* find_effect(const std::string& id) {
    for (const Effect& effect : effect_catalogue())
        if (effect.id == id) return &effect;
    return nullptr;
}

std::vector<std::string> effect_ids() {
    std::vector<std::string> ids;
    for (const Effect& effect : effect_catalogue()) ids.push_back(effect.id);
    return ids;
}

bool any_varies_within_cells(const std::vector<EffectDeclaration>& effects) {
    return std::any_of(effects.begin(), effects.end(), [](const EffectDeclaration& declaration) {
        const Effect* const effect = find_effect(declaration.id);
        return effect != nullptr && effect->varies_within_cells;
    });
}

void apply_effects(const EffectSite& site, const std::vector<EffectDeclaration>& effects, Affected& affected) {
    // stable_sort below keeps the order of declaration within an EffectStage.
    std::vector<std::pair<const Effect*, const EffectDeclaration*>> order;
    for (const EffectDeclaration& declaration : effects) {
        order.emplace_back(find_effect(declaration.id), &declaration);
        assert(order.back().first != nullptr);
    }
    // Order by EffectStage: stress-free shapes refer to the cells as supported, whatever was declared first.
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first->stage < b.first->stage; });
    for (const auto& [effect, declaration] : order)
        if (acts_on(site, declaration->parameters)) effect->apply(site, declaration->parameters, affected);
}

}  // namespace myo::effect
