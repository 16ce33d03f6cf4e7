#include "validation/synthetic_effects.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "effect/catalogue.hpp"

namespace myo::validation {
namespace {

using Eigen::VectorXd;

/// What the effects of the catalogue may read of a case.
effect::DrawContext draw_context(const SyntheticCase& c) {
    effect::DrawContext context;
    context.length_m = c.body.length_m();
    context.held_m = c.body.held_m;
    context.thickness_m = c.body.thickness_m;
    context.middle_m = c.body.bounds.lowest + 0.5 * c.body.bounds.size();
    // The bounds of the L contain its second leg, which hangs from the end of the first.
    if (c.body.family == BodyFamily::ell) context.middle_m.z() = 0.5 * c.body.thickness_m;
    context.density_kg_m3 = c.material.density_kg_m3;
    context.youngs_modulus_Pa = c.material.youngs_modulus_Pa;
    for (std::size_t m = 0; m < c.markers.size(); ++m) context.marker_names.push_back("m" + std::to_string(m + 1));
    for (const SyntheticTrial& trial : c.trials)
        context.trials.push_back({trial.name, trial.role == experiment::TrialRole::fit,
                                  trial.start == experiment::StartState::straight, trial.end_s});
    context.surface_point = [&body = c.body](RandomStream& random) { return drawn_markers(body, 2, random).back(); };
    return context;
}

}  // namespace

const effect::EffectDraw& effect_draw(const std::string& id) {
    const effect::Effect* const entry = effect::find_effect(id);
    assert(entry != nullptr);
    return entry->draw;
}

double max_amount(const SyntheticCase& c, const std::string& id) {
    const effect::EffectDraw& draw = effect_draw(id);
    return draw.limit ? std::min(draw.highest, draw.limit(draw_context(c))) : draw.highest;
}

effect::EffectDeclaration drawn_effect(const std::string& id, const SyntheticCase& c, RandomStream& random) {
    const effect::EffectDraw& draw = effect_draw(id);
    effect::EffectDeclaration effect{id, {}};
    if (draw.others) effect.parameters = draw.others(draw_context(c), random);
    if (draw.amount.empty()) return effect;
    if (effect.parameters.count(draw.amount) == 0) effect.parameters[draw.amount] = draw.has_sign ? random.sign() : 1.0;
    // Geometric mean of the plausible range: the search for a visible amount starts there.
    return with_amount(std::move(effect), std::sqrt(draw.lowest * draw.highest));
}

double effect_amount(const effect::EffectDeclaration& effect) {
    return std::abs(effect::number(effect.parameters, effect_draw(effect.id).amount));
}

effect::EffectDeclaration with_amount(effect::EffectDeclaration effect, double amount) {
    effect::EffectParameter& value = effect.parameters.at(effect_draw(effect.id).amount);
    if (auto* const v = std::get_if<VectorXd>(&value))
        *v *= amount / v->norm();
    else
        value = std::copysign(amount, std::get<double>(value));
    return effect;
}

}  // namespace myo::validation
