#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::sensitivity {

// Transposes of dynamics/creep.hpp. The adjoints of strains and rates are stored without the viscous matrix D, see
// KinematicsAdjoint. For a creeping body D is that of unit viscosity, and the vectors have two halves, (E; E_v).
// Without creep D contains the damping, and the functions return their first argument.

/// Adjoint of the strain rate history (h; h_v) of a stage.
///
/// @param of_rate     adjoint of the effective viscous rate F E + H in the residual
/// @param of_strains  adjoint of the strains (E; E_v) at the end of the stage; empty: zero
Eigen::VectorXd history_adjoint(const model::Model& model, double rate_factor_1_s, const Eigen::VectorXd& of_rate,
                                const Eigen::VectorXd& of_strains);

/// Adjoint of the strains E of the body, from that of the strains (E; E_v) of a stage, whose histories are held.
Eigen::VectorXd body_strain_adjoint(const model::Model& model, double rate_factor_1_s,
                                    const Eigen::VectorXd& of_strains);

/// Adjoints of the strains of the body and of their rates at the start of a run.
struct StartStrainAdjoint {
    Eigen::VectorXd strain, rate;  // empty: zero
};
/// Transpose of what dynamics::set_start_strains() adds for the dashpots.
///
/// @param relaxed  the dashpots start with the strains of the body
StartStrainAdjoint start_strain_adjoint(const model::Model& model, bool relaxed, Eigen::VectorXd of_strains,
                                        Eigen::VectorXd of_rates);

}  // namespace myo::sensitivity
