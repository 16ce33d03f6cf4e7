#pragma once

#include <Eigen/Core>

#include "dynamics/stage_problem.hpp"
#include "solver/fast_cholesky.hpp"

namespace myo::dynamics {

/// The global matrix of projective dynamics, inertia M + sum_q w_q (2 mu + lambda) G G', scalar: one factor serves the
/// three coordinates and every step. With the paper's energy a step in this metric is its local-global iteration.
/// Source: Bouaziz et al. 2014; Liu, Bouaziz & Kavan 2017; Dubied et al. 2022, sec. III.
class ProjectiveMetric {
public:
    /// Factors for a stage's inertia unless the factor at hand is of the same. False: the matrix is not definite.
    bool prepare(const StageProblem& problem, StageReport& report);

    /// A^-1 b, b over the free unknowns.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

private:
    solver::FastCholesky factor_;
    double inertia_1_s2_ = -1.0, until_s_ = 0.0;  // of the stages it is for: inertia, and the span of their mass
};

}  // namespace myo::dynamics
