#include "project/parameter_tangent.hpp"

#include <algorithm>
#include <cmath>

#include "effect/affected_tangent.hpp"
#include "project/study_effects.hpp"

namespace myo {
namespace {

using Kind = StudyParameter::Kind;

/// Of what matters of a number: 1e-8 of the curvature is left, and four digits are lost to rounding.
constexpr double part_to_each_side = 1e-4;

std::optional<ModelTangent> tangent_between(const Study& study, std::size_t trial, const StudyValues& values, const StudyParameter& parameter) {
    const double value = value_of(parameter, values), step = difference_step(parameter, value, part_to_each_side);
    const auto side = [&](double at) {
        StudyValues changed = values;
        set_value(parameter, std::clamp(at, parameter.parameter.lower, parameter.parameter.upper), changed);
        return std::pair{value_of(parameter, changed), affected_trial(study, trial, changed)};
    };
    const auto [low, under] = side(value - step);
    const auto [high, over] = side(value + step);
    return affected_tangent(under, affected_trial(study, trial, values), over, high - low);
}

}  // namespace

bool moves_the_body(const Study& study, std::size_t trial, const StudyValues& values, const StudyParameter& parameter) {
    switch (parameter.kind) {
        case Kind::youngs_modulus:
        case Kind::damping: return true;
        case Kind::level: return parameter.trial == trial;
        case Kind::effect: {
            const EffectDeclaration& effect = values.effects[parameter.index];
            return !is_seen_only(effect) && acts_on(effect_site(study, trial), effect.parameters);
        }
        default: return false;
    }
}

std::optional<ModelTangent> parameter_tangent(const Study& study, std::size_t trial, const StudyValues& values, const StudyParameter& parameter) {
    if (!values.effects.empty()) return tangent_between(study, trial, values, parameter);
    if (parameter.kind == Kind::youngs_modulus) return youngs_modulus_tangent(trial_model(study, trial, values), values.youngs_modulus_Pa);
    if (parameter.kind == Kind::damping) return damping_tangent();
    ModelTangent tangent;
    tangent.activation = level_tangent(study.experiment, parameter.index);
    return tangent;
}

double difference_step(const StudyParameter& p, double value, double part) {
    return part * (p.parameter.over_decades ? std::max(std::abs(value), 0.05 * p.parameter.scale) : p.parameter.scale);
}

}  // namespace myo
