#include "dynamics/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/stopwatch.hpp"
#include "solver/conjugate_gradient.hpp"

namespace myo::dynamics {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

bool solve_by_lagged_factor(const solver::SymmetricSparse& H, const MatrixXd& B, double tolerance,
                            const StageProblem& problem, const Matrix3Xd& x, LaggedFactor& factor, StageReport& report,
                            MatrixXd& solution, const MatrixXd& guess) {
    const model::Body& body = *problem.model().body;
    const auto product = [&](const MatrixXd& V) {
        const TimedScope scope(report.times.linear_s);
        return solver::symmetric_product(H, V);
    };
    const auto metric = [&](const MatrixXd& V) {
        const TimedScope scope(report.times.linear_s);
        return factor.solve(body.pattern, V);
    };
    bool fresh = false;
    // With many columns each iteration is expensive, and a factor of this very matrix needs fewer of them.
    const bool pays = B.cols() > factor.iterations_per_factorisation(body);
    if (pays || factor.is_stale(problem.stage().inertia_1_s2)) {
        if (!factor.renew_with(H, problem, x, report)) return false;
        fresh = true;
    } else {
        factor.turn_to(body, x);
    }
    while (true) {
        // The Schwarz preconditioner converges more slowly than a factor of the whole matrix.
        const int limit = std::max(factor.is_whole(body.pattern) ? 30 : 500, factor.iterations_per_factorisation(body));
        const solver::ConjugateGradientReport cg = solver::conjugate_gradient(product, metric, B, tolerance, limit,
                                                                              guess);
        report.linear_iterations += cg.iterations;
        if (cg.converged) {
            factor.charge(cg.iterations, body);
            solution = cg.solution;
            return true;
        }
        // No convergence with an old factor: renew it once, with H itself.
        if (fresh || !factor.renew_with(H, problem, x, report)) return false;
        fresh = true;
    }
}

bool mixed_newton(const StageProblem& problem, const SolverOptions& options, double scale, LaggedFactor& factor,
                  Matrix3Xd& x, StageReport& report) {
    const model::Model& model = problem.model();
    const model::Stiffness& stiffness = problem.constants().stiffness;
    // Mixed method: the pressure of the geometric stiffness is the one predicted by the last linear solve, not the one
    // of the deformed cell, with which the iteration near nu = 0.5 would need a line search.
    VectorXd pressure = model::pressures(model, stiffness, x);
    Matrix3Xd best = x;
    double best_residual = std::numeric_limits<double>::infinity();
    int without_progress = 0;
    model::HessianKind kind = model::HessianKind::exact;
    for (int iteration = 0; iteration < options.max_newton_iterations; ++iteration, ++report.newton_iterations) {
        const StageProblem::Evaluation now = problem.evaluate(x, kind, &pressure);
        const double residual = now.residual.norm() / scale;
        if (!std::isfinite(residual)) break;
        if (residual < 0.5 * best_residual)
            without_progress = 0;
        else
            ++without_progress;
        if (residual < best_residual) {
            best_residual = residual;
            best = x;
        }
        report.residual = best_residual;
        // Tolerance below rounding: the residual stagnates far below any physical force.
        const bool at_rounding = without_progress >= 2 && best_residual < 1e-9;
        if (residual <= options.tolerance || at_rounding) {
            x = best;
            return true;
        }
        if (without_progress > 6) break;
        MatrixXd step;
        // Inexact Newton: solve the linear system only as accurately as the present residual requires.
        const double accuracy = std::clamp(0.1 * residual, 1e-6, 1e-2);
        if (!solve_by_lagged_factor(now.hessian, -now.residual, accuracy, problem, x, factor, report, step)) {
            if (kind != model::HessianKind::exact || model.fibres->empty()) break;
            kind = model::HessianKind::positive_fibres;  // fibres that push make the exact Hessian indefinite
            continue;
        }
        const Matrix3Xd dx = model::scatter(problem.pattern(), step);
        pressure = model::predicted_pressures(model, stiffness, x, dx);
        if (!pressure.allFinite()) break;
        x += dx;
    }
    x = best;
    report.residual = best_residual;
    return false;
}

/// Factors the exact Hessian or, if it is indefinite or recently was, that of positive fibres or of positive cells.
///
/// @param indefinite  iterations for which the exact Hessian is skipped
/// @param hessian     in: exact Hessian; out: the matrix that was factored
static bool factor_definite(const StageProblem& problem, const Matrix3Xd& x, int& indefinite, LaggedFactor& factor,
                            solver::SymmetricSparse& hessian, StageReport& report) {
    if (indefinite == 0 && factor.renew_with(hessian, problem, x, report)) return true;
    indefinite = indefinite > 0 ? indefinite - 1 : 1;  // an indefinite Hessian is usually followed by another one
    if (!problem.model().fibres->empty()) {
        hessian = problem.evaluate(x, model::HessianKind::positive_fibres).hessian;
        if (factor.renew_with(hessian, problem, x, report)) return true;
    }
    hessian = problem.evaluate(x, model::HessianKind::positive).hessian;
    // Positive cells can leave motions without any stiffness, along which the correction would be unbounded: a small
    // shift along the mass bounds it.
    const solver::SymmetricSparse& inertia = problem.inertia();
    hessian.coeffs() += 1e-6 * hessian.diagonal().sum() / inertia.diagonal().sum() * inertia.coeffs();
    return factor.renew_with(hessian, problem, x, report);
}

bool energy_newton(const StageProblem& problem, const SolverOptions& options, double scale, LaggedFactor& factor,
                   Matrix3Xd& x, StageReport& report) {
    int indefinite = 0;  // iterations for which the projected Hessian is used
    int crawling = 0;    // iterations in a row with a line search factor below 1e-3
    for (int iteration = 0; iteration < 5 * options.max_newton_iterations && crawling < 25;
         ++iteration, ++report.newton_iterations) {
        StageProblem::Evaluation now = problem.evaluate(x, model::HessianKind::exact);
        const double residual = now.residual.norm() / scale;
        report.residual = residual;
        if (!std::isfinite(residual)) {
            report.status = SolveStatus::not_finite;
            return false;
        }
        if (residual <= options.tolerance) return true;
        if (!factor_definite(problem, x, indefinite, factor, now.hessian, report)) return false;
        MatrixXd step = -factor.solve(problem.pattern(), now.residual);
        if (!factor.is_whole(problem.pattern()) &&
            !solve_by_lagged_factor(now.hessian, -now.residual, 1e-3, problem, x, factor, report, step))
            return false;
        // Armijo line search with halving. A direction without descent cannot be improved by it.
        const double slope = now.residual.dot(step.col(0));
        if (!(slope < 0.0)) return false;
        const Matrix3Xd dx = model::scatter(problem.pattern(), step);
        double length = 1.0;
        bool accepted = false;
        for (int halving = 0; halving < 40 && !accepted; ++halving, length *= 0.5) {
            const StageProblem::Evaluation trial = problem.evaluate(x + length * dx, model::HessianKind::none);
            // If the potential cannot resolve the decrease, the residual decides; elsewhere it would allow cycles.
            const bool rounding = -slope < 1e-9 * std::abs(now.potential) || residual < 1e-3;
            accepted = trial.residual.allFinite() && (trial.potential <= now.potential + 1e-4 * length * slope ||
                                                      (rounding && trial.residual.norm() < 0.9 * now.residual.norm()));
            if (accepted) x += length * dx;
        }
        if (!accepted) return false;
        crawling = length < 1e-3 ? crawling + 1 : 0;
    }
    return false;
}

}  // namespace myo::dynamics
