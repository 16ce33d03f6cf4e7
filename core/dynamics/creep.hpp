#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::dynamics {

// Creep: a Maxwell branch (spring and dashpot in series, modulus ratio g, relaxation time tau) in parallel with the
// elastic body. For a creeping body the strain vector of a state, of a stage and of their derivatives (one column each)
// is the strain E of the body followed by the strain E_v of the dashpots; rates and histories have the same layout. An
// integrator applies one linear formula to both halves and keeps its order. A stage gives dE/dt = f E + h and
// dE_v/dt = f E_v + h_v with its rate factor f. With the evolution law dE_v/dt = (E - E_v) / tau
//   E_v = (E - tau h_v) / (1 + tau f),   E - E_v = tau (f E + h_v) / (1 + tau f).
// The stress of damping and branch together is 2 mu dev of a single rate, damping dE/dt + g (E - E_v) = F E + H, so
// that the branch costs no more than damping alone.

/// Strains of body and dashpots at the end of a stage.
///
/// @param rate_factor_1_s  f of the stage [1/s]
/// @param strain           E, one column per right-hand side (2 columns and more: derivatives)
/// @param history          (h; h_v) of the stage [1/s], twice as many rows as `strain`
/// @return                 (E; E_v)
Eigen::MatrixXd with_dashpots(const material::MaxwellBranch& branch, double rate_factor_1_s,
                              const Eigen::Ref<const Eigen::MatrixXd>& strain,
                              const Eigen::Ref<const Eigen::MatrixXd>& history);

/// Factor F of the effective viscous rate F E + H [-]: damping_s f + g tau f / (1 + tau f).
///
/// The model must creep.
double viscous_factor(const model::Model& model, double rate_factor_1_s);
/// History H of the effective viscous rate F E + H.
///
/// With rate factor 0 the history is the rate itself, and H is the whole effective rate. Linear in `history`: with
/// derivatives of the histories it returns the derivative of H.
/// @param history  (h; h_v), 2 m x k [1/s]
/// @return         m x k
Eigen::MatrixXd viscous_history(const model::Model& model, double rate_factor_1_s,
                                const Eigen::Ref<const Eigen::MatrixXd>& history);

/// Elastic energy stored in the spring of the Maxwell branch [J].
///
/// @param x       node positions, 3 x n [m]
/// @param strain  (E; E_v) of the state
/// The dashpots dissipate this energy and never add to it.
double branch_energy(const model::Model& model, const Eigen::Matrix3Xd& x, const Eigen::VectorXd& strain);

}  // namespace myo::dynamics
