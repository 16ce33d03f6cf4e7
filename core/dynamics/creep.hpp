#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::dynamics {

// The strains of a state, of a stage and of their derivatives (a column each) are, where a body creeps, those of the
// body, E, followed by as many of its dashpots, E_v, and rates and histories alike: an integrator treats all of them by
// the same linear formula, which keeps its order. So a stage knows dE/dt = f E + h and dE_v/dt = f E_v + h_v, and with
// dE_v/dt = (E - E_v) / tau
//   E_v = (E - tau h_v) / (1 + tau f),   E - E_v = tau (f E + h_v) / (1 + tau f).
// The stress of damping and branch together is then 2 mu dev of one rate, damping dE/dt + g (E - E_v) = F E + H.

/// E followed by E_v, from E and the histories (of both) of a stage with this rate factor.
Eigen::MatrixXd with_dashpots(const material::MaxwellBranch& branch, double rate_factor_1_s,
                              const Eigen::Ref<const Eigen::MatrixXd>& strain,
                              const Eigen::Ref<const Eigen::MatrixXd>& history);

/// F and H. With the factor 0, of histories that are rates, H is the whole rate; or its change along changes of the
/// rates.
double viscous_factor(const model::Model& model, double rate_factor_1_s);
Eigen::MatrixXd viscous_history(const model::Model& model, double rate_factor_1_s,
                                const Eigen::Ref<const Eigen::MatrixXd>& history);

/// Energy that the branch stores at x with the strains of a state [J]; its dashpots only take from it.
double branch_energy(const model::Model& model, const Eigen::Matrix3Xd& x, const Eigen::VectorXd& strain);

}  // namespace myo::dynamics
