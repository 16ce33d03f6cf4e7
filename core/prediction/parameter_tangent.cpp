#include "prediction/parameter_tangent.hpp"

#include <algorithm>
#include <cmath>

#include "effect/affected_tangent.hpp"
#include "effect/catalogue.hpp"
#include "setup/actuator_signals.hpp"
#include "setup/trial_effects.hpp"

namespace myo::prediction {
namespace {

using Kind = ModelParameter::Kind;

struct ParameterTangentPolicy {
    /// Half width of the central difference, relative to the scale of the parameter: a truncation error of 1e-8 of the
    /// curvature, and four digits lost to rounding.
    double part_to_each_side = 1e-4;
};
constexpr ParameterTangentPolicy parameter_tangent_policy;

/// Central difference of the whole model with effects. Effects may change any part of it, so no closed form is
/// available.
std::optional<sensitivity::ModelTangent> tangent_between(const setup::Setup& setup, std::size_t trial,
                                                         const ParameterValues& values,
                                                         const ModelParameter& parameter) {
    const double value = value_of(parameter, values),
                 step = difference_step(parameter, value, parameter_tangent_policy.part_to_each_side);
    const auto side = [&](double at) {
        ParameterValues changed = values;
        set_value(parameter, std::clamp(at, parameter.parameter.lower, parameter.parameter.upper), changed);
        // The value is read back because clamping to the bounds can shorten one side.
        return std::pair{value_of(parameter, changed), affected_trial(setup, trial, changed)};
    };
    const auto [low, under] = side(value - step);
    const auto [high, over] = side(value + step);
    return effect::affected_tangent(under, affected_trial(setup, trial, values), over, high - low);
}

/// The derivative that the entry of an effect states.
std::optional<sensitivity::ModelTangent> closed_form(const setup::Setup& setup, std::size_t trial,
                                                     const ParameterValues& values, const ModelParameter& parameter) {
    const effect::EffectDeclaration& effect = values.effects[parameter.index];
    const effect::Effect* const entry = effect::find_effect(effect);
    if (entry == nullptr || !entry->tangent) return std::nullopt;
    return entry->tangent(effect.parameters, parameter.of_effect, parameter.component,
                          affected_trial(setup, trial, values));
}

}  // namespace

bool moves_the_body(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                    const ModelParameter& parameter) {
    switch (parameter.kind) {
        case Kind::youngs_modulus:
        case Kind::damping:
        case Kind::part_modulus:
        case Kind::part_damping:
        case Kind::law: return true;
        case Kind::level: return parameter.trial == trial;
        case Kind::effect: {
            const effect::EffectDeclaration& effect = values.effects[parameter.index];
            return !setup::changes_observation_only(effect) &&
                   effect::acts_on(setup::trial_context(setup, trial), effect.parameters);
        }
        // Registration and start shift change the observation only.
        default: return false;
    }
}

std::optional<sensitivity::ModelTangent> parameter_tangent(const setup::Setup& setup, std::size_t trial,
                                                           const ParameterValues& values,
                                                           const ModelParameter& parameter) {
    if (parameter.kind == Kind::effect)
        if (std::optional<sensitivity::ModelTangent> exact = closed_form(setup, trial, values, parameter)) return exact;
    // A cell at an interface depends on the values of several materials.
    if (!values.effects.empty() || setup.part_shares.size() > 0)
        return tangent_between(setup, trial, values, parameter);
    if (parameter.kind == Kind::youngs_modulus)
        return sensitivity::youngs_modulus_tangent(trial_model(setup, trial, values), values.youngs_modulus_Pa);
    if (parameter.kind == Kind::damping) return sensitivity::damping_tangent();
    if (parameter.kind == Kind::law) return sensitivity::law_tangent(parameter.index);
    return setup::level_model_tangent(setup.experiment, parameter.index, setup.trials[trial].model);
}

double difference_step(const ModelParameter& p, double value, double part) {
    return part * (p.parameter.over_decades ? std::max(std::abs(value), 0.05 * p.parameter.scale) : p.parameter.scale);
}

}  // namespace myo::prediction
