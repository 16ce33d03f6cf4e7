#pragma once

#include <Eigen/Core>

#include "dynamics/lagged_factor.hpp"
#include "dynamics/solver_options.hpp"
#include "dynamics/stage_problem.hpp"

namespace myo::dynamics {

/// Newton's method on the displacements with the cell pressures as lagged unknowns in the geometric stiffness.
///
/// This is the iteration of the mixed displacement-pressure method with the pressures condensed out. Near nu = 0.5 it
/// converges without a line search, where the displacement iteration needs one. The linear systems are solved by
/// conjugate gradients, preconditioned with the lagged factor.
/// @param scale   force that makes the residual relative [N]
/// @param x       in: initial guess; out: solution, or the best iterate on failure. 3 x n [m]
/// @param report  residual and counts are added
/// @return        true if the residual is within options.tolerance, or at rounding
/// Source: Bonet & Wood 2008, sec. 8.6 (pressure); Nocedal & Wright 2006, ch. 7.
bool mixed_newton(const StageProblem& problem, const SolverOptions& options, double scale, LaggedFactor& factor,
                  Eigen::Matrix3Xd& x, StageReport& report);

/// Newton's method with a line search on the potential. Where the Hessian is indefinite, cell matrices are projected to
/// be positive semidefinite. Slow but robust; the last resort. Without a potential the residual must decrease instead.
/// Parameters as above.
bool energy_newton(const StageProblem& problem, const SolverOptions& options, double scale, LaggedFactor& factor,
                   Eigen::Matrix3Xd& x, StageReport& report);

/// Solves H X = B by conjugate gradients with the lagged factor as preconditioner. For a body with forces without
/// potential: solves (H + N) X = B, N the rest of the stiffness, or the transpose, by GMRES, unless the symmetric form
/// is asked for.
///
/// @param B          unknowns x k
/// @param tolerance  relative residual
/// @param x          positions of H, 3 x n [m]; the factor is rotated to them, or renewed with H
/// @param guess      initial X; may be empty
/// @return           false if H is not positive definite or the iteration limit is reached
bool solve_by_lagged_factor(const solver::SymmetricSparse& H, const Eigen::MatrixXd& B, double tolerance,
                            const StageProblem& problem, const Eigen::Matrix3Xd& x, LaggedFactor& factor,
                            StageReport& report, Eigen::MatrixXd& solution, const Eigen::MatrixXd& guess = {},
                            model::StiffnessForm form = model::StiffnessForm::complete);

}  // namespace myo::dynamics
