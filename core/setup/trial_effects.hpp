#pragma once

#include <vector>

#include "effect/effect.hpp"
#include "setup/setup.hpp"

namespace myo::setup {

/// Context of a trial that effects may read: body, clamp, markers, actuators, times.
///
/// @param trial  index into Setup::trials
effect::TrialContext trial_context(const Setup& setup, std::size_t trial);

/// Model, simulation options and observation of a trial with the effects applied.
///
/// @param model    model of the trial without effects
/// @param effects  applied in this order; end_s is extended if the observation needs later times
effect::Affected with_effects(const Setup& setup, std::size_t trial, model::Model model,
                              const std::vector<effect::EffectDeclaration>& effects);

/// Whether an effect changes the observation only and not the motion.
bool changes_observation_only(const effect::EffectDeclaration& effect);

/// A scalar degree of freedom of an effect that a fit may change: a parameter, a component of a vector, or an angle of
/// a direction.
struct EffectNumber {
    std::string parameter;                         // key in EffectDeclaration::parameters
    int component = -1;                            // component of a vector or index of an angle; -1: scalar parameter
    std::string name;                              // see effect::fitted_names()
    double lower = 0.0, upper = 0.0, scale = 1.0;  // bounds and typical magnitude, in the unit of the parameter
    bool over_decades = false;                     // the fit scales it logarithmically
    /// Direction: unit vector from which the angles are measured; zero otherwise.
    Eigen::Vector3d base = Eigen::Vector3d::Zero();
};
/// All degrees of freedom of an effect; parameters without a scale in the catalogue are fixed.
///
/// @param signal_size  see signal_size(): multiplies range and scale of parameters in the unit of the signal
std::vector<EffectNumber> effect_numbers(const effect::EffectDeclaration& effect, double signal_size = 1.0);
/// Size of the signals that an effect on the actuation acts on, in their unit: 1 if they are all muscles', otherwise
/// the largest pressure, tension or shortening of the trials.
double signal_size(const Setup& setup, const effect::EffectDeclaration& effect);
/// Current value of one degree of freedom, in the unit of the parameter; angles in rad.
///
/// @param component, base  as in EffectNumber
double effect_number(const effect::EffectDeclaration& effect, const std::string& parameter, int component,
                     const Eigen::Vector3d& base = Eigen::Vector3d::Zero());
/// Sets one degree of freedom; the arguments are those of effect_number(). Bounds are not checked.
void set_effect_number(effect::EffectDeclaration& effect, const std::string& parameter, int component, double value,
                       const Eigen::Vector3d& base = Eigen::Vector3d::Zero());

}  // namespace myo::setup
