#pragma once

#include <Eigen/Core>

#include "dynamics/lagged_factor.hpp"
#include "dynamics/solver_options.hpp"
#include "dynamics/stage_problem.hpp"

namespace myo::dynamics {

/// Newton's method on the displacements with each cell's pressure as a lagged unknown in the geometric stiffness: the
/// iteration of the mixed method, condensed, which needs no line search at nu near 0.5 where the displacement iteration
/// does. The linear systems are solved by conjugate gradients with the lagged factor as preconditioner. On failure x is
/// the best iterate. Source: Bonet & Wood 2008, sec. 8.6 (pressure); Nocedal & Wright 2006, ch. 7.
bool mixed_newton(const StageProblem& problem, const SolverOptions& options, double scale, LaggedFactor& factor,
                  Eigen::Matrix3Xd& x, StageReport& report);

/// Newton's method with a line search on the potential and, where the Hessian is indefinite, projected cells: slow and
/// sure.
bool energy_newton(const StageProblem& problem, const SolverOptions& options, double scale, LaggedFactor& factor,
                   Eigen::Matrix3Xd& x, StageReport& report);

/// H^-1 B to the tolerance by conjugate gradients from `guess` (may be empty). False where H is not positive definite
/// or the limit is met.
bool solve_by_lagged_factor(const solver::SymmetricSparse& H, const Eigen::MatrixXd& B, double tolerance,
                            const StageProblem& problem, const Eigen::Matrix3Xd& x, LaggedFactor& factor,
                            StageReport& report, Eigen::MatrixXd& solution, const Eigen::MatrixXd& guess = {});

}  // namespace myo::dynamics
