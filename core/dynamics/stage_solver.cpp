#include "dynamics/stage_solver.hpp"

#include <cmath>
#include <limits>

#include "base/cancellation.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "dynamics/newton.hpp"
#include "dynamics/quasi_newton.hpp"
#include "solver/conjugate_gradient.hpp"

namespace myo::dynamics {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

StageSolver::StageSolver(const model::Model& model, SolverOptions options)
    : options_(options), constants_(stage_constants(model)), factor_(options.max_factor_entries) {}

// The factor of the earlier moduli is kept: it is only a metric, and is renewed when it converges slowly.
void StageSolver::soften(const VectorXd& factors) {
    softening_ = factors;
    constants_.stiffness.elastic_factors = model::times_factors(model().point_factors, factors);
}

bool StageSolver::lagged_newton(const StageProblem& problem, double scale, Matrix3Xd& x, StageReport& report) {
    const model::Body& body = *model().body;
    QuasiNewtonOptions options;
    options.tolerance = options_.tolerance;
    options.scale = scale;
    const auto metric = [&](const VectorXd& b) {
        const TimedScope scope(report.times.linear_s);
        return VectorXd(factor_.solve(body.pattern, b));
    };
    bool fresh = factor_.is_stale(problem.stage().inertia_1_s2);
    if (fresh && !factor_.renew(problem, x, report)) return false;
    if (!fresh) factor_.turn_to(body, x);
    while (true) {
        if (fresh) {  // with a fresh factor there is no better alternative to slow convergence
            options.max_iterations = 60;
            options.slow_contraction = 0.9;
        }
        const QuasiNewtonResult result = quasi_newton(problem, options, metric, x);
        report.newton_iterations += result.iterations;
        report.residual = result.residual;
        factor_.charge(result.iterations, body);
        if (result.converged) return true;
        if (fresh || !std::isfinite(result.residual) || cancellation_.cancelled() || cancellation_requested())
            return false;
        if (!factor_.renew(problem, x, report)) return false;
        fresh = true;
    }
}

StageReport StageSolver::solve(const Stage& stage, Matrix3Xd& x) {
    StageReport report;
    // Inside a solve, cancellation ends the factorisations and linear solves, without which no iteration goes on.
    if (cancellation_.cancelled() || cancellation_requested()) {
        report.status = SolveStatus::not_converged;
        report.message = "stopped";
        return report;
    }
    const StageProblem problem(constants_, stage, &report.times, &cancellation_);
    const double scale = problem.force_scale(x, options_.tolerance);
    const auto converged = [&]() {
        report.status = SolveStatus::converged;
        return report;
    };
    const Matrix3Xd start = x;
    // Sequence of methods: the chosen one, mixed Newton from its result, mixed Newton from the guess, energy Newton.
    const bool conservative = model::has_potential(model());  // quasi-Newton methods minimise the potential
    if (conservative && options_.strategy == Strategy::projective && projective_.prepare(problem, report)) {
        QuasiNewtonOptions options;
        options.tolerance = options_.tolerance;
        options.scale = scale;
        options.max_iterations = 2000;
        options.slow_contraction = std::numeric_limits<double>::infinity();
        const auto metric = [&](const VectorXd& b) {
            const TimedScope scope(report.times.linear_s);
            return projective_.solve(b);
        };
        const QuasiNewtonResult result = quasi_newton(problem, options, metric, x);
        report.newton_iterations += result.iterations;
        report.residual = result.residual;
        if (result.converged) return converged();
    } else if (options_.strategy != Strategy::newton && factor_.is_whole(problem.pattern()) && conservative) {
        if (lagged_newton(problem, scale, x, report)) return converged();
    }
    if (!x.allFinite()) x = start;
    if (factor_.is_whole(problem.pattern()))
        factor_.mark_stale();  // a Schwarz preconditioner stays useful longer than a factor
    if (mixed_newton(problem, options_, scale, factor_, x, report)) return converged();
    // Many small decreases of the potential can end at squeezed cells with an indefinite Hessian, where Newton's method
    // fails; from the original guess it often converges.
    Matrix3Xd afresh = start;
    if (mixed_newton(problem, options_, scale, factor_, afresh, report)) {
        x = afresh;
        return converged();
    }
    const bool found = energy_newton(problem, options_, scale, factor_, x, report);
    factor_.mark_stale();
    if (found) return converged();
    if (report.status == SolveStatus::not_run) report.status = SolveStatus::not_converged;
    if (!std::isfinite(report.residual)) {
        report.status = SolveStatus::not_finite;
        report.message =
            "the step did not converge: the forces on the body are not finite, it is torn or turned inside out; check "
            "the units of modulus, density, gravity and loads";
        return report;
    }
    report.message = "the step did not converge: after " + std::to_string(report.newton_iterations) +
                     " iterations the residual is " + format_number(report.residual, 2) + " of the forces on the body";
    return report;
}

solver::SymmetricSparse StageSolver::hessian(const Stage& stage, const Matrix3Xd& x) {
    StageProblem::Evaluation evaluation = StageProblem(constants_, stage).evaluate(x, model::HessianKind::exact);
    solver::SymmetricSparse H;
    H.swap(evaluation.hessian);  // Eigen's sparse matrices cannot be moved
    return H;
}

MatrixXd StageSolver::solve_linear(const solver::SymmetricSparse& H, const Stage& stage, const Matrix3Xd& x,
                                   const MatrixXd& B, const MatrixXd& guess, model::StiffnessForm form) {
    if (B.isZero(0.0)) return MatrixXd::Zero(B.rows(), B.cols());
    StageReport unused;
    MatrixXd solution;
    if (solve_by_lagged_factor(H, B, options_.tangent_tolerance, StageProblem(constants_, stage), x, factor_, unused,
                               solution, guess, form))
        return solution;
    // Indefinite Hessian at a converged state (a buckling body): direct factorisation in double precision.
    solver::SparseCholesky exact;
    const bool symmetric = form == model::StiffnessForm::symmetric || model::has_potential(model());
    if (symmetric && exact.factorize(H)) return exact.solve(B);
    return MatrixXd::Constant(B.rows(), B.cols(), std::numeric_limits<double>::quiet_NaN());
}

MatrixXd StageSolver::stiffness_product(const solver::SymmetricSparse& H, const Stage& stage, const Matrix3Xd& x,
                                        const MatrixXd& V, model::StiffnessForm form) const {
    MatrixXd result = solver::symmetric_product(H, V);
    if (model::has_potential(model())) return result;
    const StageProblem problem(constants_, stage);
    for (Eigen::Index k = 0; k < V.cols(); ++k) result.col(k) += problem.unsymmetric_product(x, V.col(k), form);
    return result;
}

Matrix3Xd StageSolver::total_forces(const Stage& stage, const Matrix3Xd& x) {
    // The residual of the stage without inertia is minus the total force.
    Stage without_inertia = stage;
    without_inertia.inertia_1_s2 = 0.0;
    without_inertia.constant = Matrix3Xd::Zero(3, x.cols());
    return model::scatter(model().body->pattern,
                          -StageProblem(constants_, without_inertia).evaluate(x, model::HessianKind::none).residual);
}

}  // namespace myo::dynamics
