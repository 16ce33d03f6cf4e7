#include "effect/catalogue.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "model/mount_forces.hpp"

namespace myo::effect {

/// All effects, in the order of the vocabulary, of lists and of reports. A new effect is a file of its own and one line
/// here, the name of the function that it defines; tests run over the catalogue.
// clang-format off
#define MYOLOOP_EFFECTS(entry) \
    entry(quadratic_drag) \
    entry(linear_drag) \
    entry(added_mass) \
    entry(point_mass) \
    entry(cable_tug) \
    entry(dry_friction) \
    entry(end_stop) \
    entry(hung_mass) \
    entry(gravity_tilt) \
    entry(tendon_friction) \
    entry(tendon_channel) \
    entry(base_vibration) \
    entry(clamp_compliance) \
    entry(clamp_slip) \
    entry(held_pose) \
    entry(extra_damping) \
    entry(viscoelastic_creep) \
    entry(strain_stiffening_effect) \
    entry(stress_softening) \
    entry(stiffness_gradient) \
    entry(soft_patch) \
    entry(modulus_drift) \
    entry(intrinsic_curvature) \
    entry(actuation_lag) \
    entry(actuation_delay) \
    entry(actuation_gain) \
    entry(actuation_leak) \
    entry(actuation_hysteresis) \
    entry(clock_offset) \
    entry(frame_rate_error) \
    entry(scale_error) \
    entry(marker_swap) \
    entry(marker_offset) \
    entry(marker_slip)
// clang-format on

#define MYOLOOP_DECLARE(name) Effect name();
MYOLOOP_EFFECTS(MYOLOOP_DECLARE)

const std::vector<Effect>& effect_catalogue() {
#define MYOLOOP_CALL(name) name(),
    static const std::vector<Effect> effects = {MYOLOOP_EFFECTS(MYOLOOP_CALL)};
    return effects;
}

const Effect* find_effect(const std::string& id) {
    for (const Effect& effect : effect_catalogue())
        if (effect.id == id) return &effect;
    return nullptr;
}

LawPointer find_law(const std::string& id, const Laws& laws) {
    for (const LawPointer& law : laws)
        if (law->id == id) return law;
    return nullptr;
}

const Effect* find_effect(const std::string& id, const Laws& laws) {
    if (const LawPointer law = find_law(id, laws)) return law.get();
    return find_effect(id);
}

const Effect* find_effect(const EffectDeclaration& declaration) {
    return declaration.law ? declaration.law.get() : find_effect(declaration.id);
}

std::vector<const Effect*> all_effects(const Laws& laws) {
    std::vector<const Effect*> all;
    for (const Effect& effect : effect_catalogue()) all.push_back(&effect);
    for (const LawPointer& law : laws) all.push_back(law.get());
    return all;
}

std::vector<std::string> effect_ids(const Laws& laws) {
    std::vector<std::string> ids;
    for (const Effect* const effect : all_effects(laws)) ids.push_back(effect->id);
    return ids;
}

namespace {

/// Whether the entry of any of these effects has a trait. Declarations without an entry are skipped.
bool any_with(const std::vector<EffectDeclaration>& effects, bool Effect::*trait) {
    return std::any_of(effects.begin(), effects.end(), [&](const EffectDeclaration& declaration) {
        const Effect* const effect = find_effect(declaration);
        return effect != nullptr && effect->*trait;
    });
}

}  // namespace

bool any_varies_within_cells(const std::vector<EffectDeclaration>& effects) {
    return any_with(effects, &Effect::varies_within_cells);
}

bool any_has_corner(const std::vector<EffectDeclaration>& effects) { return any_with(effects, &Effect::has_corner); }

namespace {

/// Puts the body on the mount as it moves, see model::mount_forces(): what acts from the laboratory is seen from the
/// mount, inertia forces come last.
///
/// @param outside  number of force elements that act from outside or are actuators; those behind them join the body to
///                 its mount
void put_on_mount(std::size_t outside, Affected& affected) {
    measurement::ObservationError& error = affected.observation_error;
    error.mount = model::with_vibrations(
        model::by_clock(affected.recorded_mount, error.clock_offset_s, 1.0 + error.rate_error),
        affected.mount_vibrations);
    if (!error.mount) return;
    std::vector<model::ForceElementPointer>& elements = affected.model.force_elements;
    // Actuators are part of the body.
    for (std::size_t e = 0; e < outside; ++e)
        if (!elements[e]->command()) elements[e] = model::in_laboratory(elements[e], error.mount);
    elements.push_back(model::mount_forces(affected.model, error.mount));
}

}  // namespace

void apply_effects(const TrialContext& context, const std::vector<EffectDeclaration>& effects, Affected& affected) {
    // stable_sort below keeps the order of declaration within an EffectKind.
    std::vector<std::pair<const Effect*, const EffectDeclaration*>> order;
    for (const EffectDeclaration& declaration : effects) {
        order.emplace_back(find_effect(declaration), &declaration);
        assert(order.back().first != nullptr);
    }
    // Order by EffectKind: stress-free shapes refer to the cells as supported, whatever was declared first.
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first->kind < b.first->kind; });
    std::size_t outside = affected.model.force_elements.size();
    for (const auto& [effect, declaration] : order) {
        if (!acts_on(context, declaration->parameters)) continue;
        effect->apply(context, declaration->parameters, affected);
        // Forces come first in the order, so that supports and later kinds append behind `outside`.
        if (effect->kind == EffectKind::force) outside = affected.model.force_elements.size();
    }
    put_on_mount(outside, affected);
}

}  // namespace myo::effect
