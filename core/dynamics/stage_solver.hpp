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

/// Solves the stages of one model. Caches the mass, the factor and the projective metric between solves.
/// Not thread-safe; the model must outlive the solver.
class StageSolver {
public:
    explicit StageSolver(const model::Model& model, SolverOptions options = {});

    const model::Model& model() const { return *constants_.model; }
    const SolverOptions& options() const { return options_; }
    /// Mass matrix at an instant [s].
    const model::MassMatrix& mass(double at_s) const {
        return constants_.masses[model::span_at(constants_.masses, at_s)].mass;
    }
    /// Stiffness of the cells, softening included.
    const model::Stiffness& stiffness() const { return constants_.stiffness; }

    /// Sets the progress whose cancellation ends a solve: it returns not_converged at its next evaluation or
    /// factorisation.
    void stop_with(const Progress& progress) { cancellation_ = progress.with_sink({}); }

    /// Multiplies the elastic moduli at the quadrature points by `factors`; empty: virgin moduli, as initially.
    void soften(const Eigen::VectorXd& factors);
    const Eigen::VectorXd& softening() const { return softening_; }

    /// Solves the stage for x by the strategy of the options, with fallback to Newton's method.
    ///
    /// @param x  in: initial guess; out: solution, or the best iterate on failure. 3 x n [m]
    /// Errors: status and message of the report.
    StageReport solve(const Stage& stage, Eigen::Matrix3Xd& x);

    /// Exact Hessian of the stage at x over the free unknowns [N/m].
    solver::SymmetricSparse hessian(const Stage& stage, const Eigen::Matrix3Xd& x);

    /// Solves H X = B to options.tangent_tolerance. For a body with forces without potential the rest of the stiffness
    /// is added to H, in the form asked for.
    ///
    /// @param H      Hessian of the stage at x
    /// @param B      unknowns x k
    /// @param guess  initial X; may be empty
    /// Errors: NaN if H is singular.
    Eigen::MatrixXd solve_linear(const solver::SymmetricSparse& H, const Stage& stage, const Eigen::Matrix3Xd& x,
                                 const Eigen::MatrixXd& B, const Eigen::MatrixXd& guess = {},
                                 model::StiffnessForm form = model::StiffnessForm::complete);

    /// Product of the stiffness of the stage at x, H and the rest of it, complete or transposed, with nodal fields,
    /// both unknowns x k.
    Eigen::MatrixXd stiffness_product(const solver::SymmetricSparse& H, const Stage& stage, const Eigen::Matrix3Xd& x,
                                      const Eigen::MatrixXd& V,
                                      model::StiffnessForm form = model::StiffnessForm::complete) const;

    /// External minus internal forces at x, 3 x n [N], zero on clamped nodes. Strain rates as in the stage; inertia is
    /// not included.
    Eigen::Matrix3Xd total_forces(const Stage& stage, const Eigen::Matrix3Xd& x);

    /// Stored entries of the present factor.
    double factor_entries() const { return factor_.factor_entries(); }

private:
    /// L-BFGS in the metric of the lagged factor; the factor is renewed at most once per solve.
    bool lagged_newton(const StageProblem& problem, double scale, Eigen::Matrix3Xd& x, StageReport& report);

    SolverOptions options_;
    Progress cancellation_;
    StageConstants constants_;
    Eigen::VectorXd softening_;  // factors of the elastic moduli; empty: virgin
    LaggedFactor factor_;
    ProjectiveMetric projective_;
};

}  // namespace myo::dynamics
