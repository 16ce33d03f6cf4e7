#pragma once

#include <vector>

#include "effect/effect.hpp"
#include "setup/setup.hpp"

namespace myo::setup {

/// What effects may know of a trial.
effect::EffectSite effect_site(const Setup& setup, std::size_t trial);

/// A trial's model, run and observation with the effects in.
effect::Affected with_effects(const Setup& setup, std::size_t trial, model::Model model,
                              const std::vector<effect::EffectDeclaration>& effects);

/// Whether an effect changes what is seen alone, and not the motion.
bool is_seen_only(const effect::EffectDeclaration& effect);

/// Numbers of an effect that a fit may move: a parameter, a component of one, or an angle of a direction.
struct EffectNumber {
    std::string parameter;
    int component = -1;  // of a vector, or which angle of a direction; -1: the number itself
    std::string name;    // "effect.quadratic_drag.coefficient_kg_m3", "effect.point_mass.position_m.x",
                         // "effect.gravity_tilt.axis.turn_1_rad"
    double lower = 0.0, upper = 0.0, scale = 1.0;
    bool over_decades = false;
    Eigen::Vector3d base = Eigen::Vector3d::Zero();  // of a direction: the one from which the angles are measured; zero
                                                     // for all others
};
std::vector<EffectNumber> effect_numbers(const effect::EffectDeclaration& effect);
/// @param base  as of EffectNumber
double effect_number(const effect::EffectDeclaration& effect, const std::string& parameter, int component,
                     const Eigen::Vector3d& base = Eigen::Vector3d::Zero());
void set_effect_number(effect::EffectDeclaration& effect, const std::string& parameter, int component, double value,
                       const Eigen::Vector3d& base = Eigen::Vector3d::Zero());

}  // namespace myo::setup
