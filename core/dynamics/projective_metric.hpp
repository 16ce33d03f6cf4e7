#pragma once

#include <Eigen/Core>

#include "dynamics/stage_problem.hpp"
#include "solver/fast_cholesky.hpp"

namespace myo::dynamics {

/// Global matrix of projective dynamics, inertia M + sum_q w_q (2 mu + lambda) G G'.
///
/// The matrix is scalar (one unknown per node): one factor serves the three coordinates and all steps. With the paper's
/// energy, a quasi-Newton iteration in this metric equals a local-global iteration.
/// Source: Bouaziz et al. 2014; Liu, Bouaziz & Kavan 2017; Dubied et al. 2022, sec. III.
class ProjectiveMetric {
public:
    /// Factors the matrix for the inertia and mass span of the stage, unless the present factor is for the same ones.
    /// Returns false if the matrix is not positive definite.
    bool prepare(const StageProblem& problem, StageReport& report);

    /// A^-1 b; b: free unknowns, three per node.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

private:
    solver::FastCholesky factor_;
    double inertia_1_s2_ = -1.0, until_s_ = 0.0;  // inertia factor and mass span of the present factor
};

}  // namespace myo::dynamics
