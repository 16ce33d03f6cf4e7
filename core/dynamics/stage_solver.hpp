#pragma once

#include <Eigen/Core>

#include "base/progress.hpp"
#include "dynamics/lagged_factor.hpp"
#include "dynamics/projective_metric.hpp"
#include "dynamics/solver_options.hpp"
#include "dynamics/stage.hpp"
#include "dynamics/stage_problem.hpp"
#include "model/model.hpp"
#include "solver/sparse_cholesky.hpp"

namespace myo::dynamics {

/// Solves stages of one model. Keeps what is worth keeping between them: mass, factor.
/// Not to be shared between threads.
class StageSolver {
public:
    explicit StageSolver(const model::Model& model, SolverOptions options = {});

    const model::Model& model() const { return *constants_.model; }
    const model::MassMatrix& mass(double at_s) const {
        return constants_.masses[model::span_at(constants_.masses, at_s)].mass;
    }
    const model::Stiffness& stiffness() const { return constants_.stiffness; }

    /// Solves end unconverged as soon as this is cancelled: within an evaluation of the forces, or a factorisation.
    void heed(const Progress& progress) { heeded_ = progress.with_sink({}); }

    /// The elastic moduli at the points are these parts of the model's from now on; empty: of virgin ones, as at first.
    void soften(const Eigen::VectorXd& factors);
    const Eigen::VectorXd& softening() const { return softening_; }

    /// Solves for x, starting from its value, by the strategy of the options. On failure x is the best iterate.
    StageReport solve(const Stage& stage, Eigen::Matrix3Xd& x);

    /// Exact Hessian of the stage at x over the free unknowns.
    solver::SymmetricSparse hessian(const Stage& stage, const Eigen::Matrix3Xd& x);

    /// H^-1 B to the tangent tolerance for the Hessian of the stage at x; B is unknowns x k. `guess`: where to start,
    /// may be empty. Not finite where H is singular.
    Eigen::MatrixXd solve_linear(const solver::SymmetricSparse& H, const Stage& stage, const Eigen::Matrix3Xd& x,
                                 const Eigen::MatrixXd& B, const Eigen::MatrixXd& guess = {});

    /// External minus internal forces at x for the strain rate of the stage (inertia not included), 3 x n, zero on
    /// clamped nodes.
    Eigen::Matrix3Xd total_forces(const Stage& stage, const Eigen::Matrix3Xd& x);

    /// Entries of the factor at hand.
    double factor_entries() const { return factor_.factor_entries(); }

private:
    bool lagged_newton(const StageProblem& problem, double scale, Eigen::Matrix3Xd& x, StageReport& report);

    SolverOptions options_;
    Progress heeded_;
    StageConstants constants_;
    Eigen::VectorXd softening_;
    LaggedFactor factor_;
    ProjectiveMetric projective_;
};

}  // namespace myo::dynamics
