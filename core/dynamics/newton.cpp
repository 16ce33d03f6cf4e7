#include "dynamics/newton.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/stopwatch.hpp"
#include "solver/conjugate_gradient.hpp"
#include "solver/gmres.hpp"

namespace myo::dynamics {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// One solve with the present factor; false: not converged within the limit.
using SolveOnce = std::function<bool(int limit, int& iterations, MatrixXd& solution)>;

/// GMRES for each column of B: H and the rest of the stiffness.
static SolveOnce unsymmetric_solve(const solver::SymmetricSparse& H, const MatrixXd& B, double tolerance,
                                   const StageProblem& problem, const Matrix3Xd& x, const LaggedFactor& factor,
                                   const MatrixXd& guess, model::StiffnessForm form) {
    return [&, tolerance, form](int limit, int& iterations, MatrixXd& solution) {
        const auto product = [&](const VectorXd& v) {
            return VectorXd(solver::symmetric_product(H, v) + problem.unsymmetric_product(x, v, form));
        };
        const auto metric = [&](const VectorXd& v) { return VectorXd(factor.solve(problem.pattern(), v)); };
        solution.resize(B.rows(), B.cols());
        for (Eigen::Index k = 0; k < B.cols(); ++k) {
            const VectorXd start = guess.size() > 0 ? VectorXd(guess.col(k)) : VectorXd();
            const solver::GmresReport found = solver::gmres(product, metric, B.col(k), tolerance, limit, start);
            iterations += found.iterations;
            if (!found.converged) return false;
            solution.col(k) = found.solution;
        }
        return true;
    };
}

static SolveOnce symmetric_solve(const solver::SymmetricSparse& H, const MatrixXd& B, double tolerance,
                                 const StageProblem& problem, const LaggedFactor& factor, StageReport& report,
                                 const MatrixXd& guess) {
    return [&, tolerance](int limit, int& iterations, MatrixXd& solution) {
        const auto product = [&](const MatrixXd& V) {
            const TimedScope scope(report.times.linear_s);
            return solver::symmetric_product(H, V);
        };
        const auto metric = [&](const MatrixXd& V) {
            const TimedScope scope(report.times.linear_s);
            return factor.solve(problem.pattern(), V);
        };
        solver::ConjugateGradientReport cg = solver::conjugate_gradient(product, metric, B, tolerance, limit, guess);
        iterations += cg.iterations;
        if (cg.converged) solution = std::move(cg.solution);
        return cg.converged;
    };
}

bool solve_by_lagged_factor(const solver::SymmetricSparse& H, const MatrixXd& B, double tolerance,
                            const StageProblem& problem, const Matrix3Xd& x, LaggedFactor& factor, StageReport& report,
                            MatrixXd& solution, const MatrixXd& guess, model::StiffnessForm form) {
    const model::Body& body = *problem.model().body;
    const bool symmetric = form == model::StiffnessForm::symmetric || model::has_potential(problem.model());
    const SolveOnce solve = symmetric ? symmetric_solve(H, B, tolerance, problem, factor, report, guess)
                                      : unsymmetric_solve(H, B, tolerance, problem, x, factor, guess, form);
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
        int iterations = 0;
        const bool converged = solve(limit, iterations, solution);
        report.linear_iterations += iterations;
        if (converged) {
            factor.charge(iterations, body);
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
    const bool conservative = model::has_potential(problem.model());
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
        if ((!factor.is_whole(problem.pattern()) || !conservative) &&
            !solve_by_lagged_factor(now.hessian, -now.residual, 1e-3, problem, x, factor, report, step))
            return false;
        // Armijo line search with halving. A direction without descent cannot be improved by it.
        const double slope = now.residual.dot(step.col(0));
        if (conservative && !(slope < 0.0)) return false;
        const Matrix3Xd dx = model::scatter(problem.pattern(), step);
        double length = 1.0;
        bool accepted = false;
        for (int halving = 0; halving < 40 && !accepted; ++halving, length *= 0.5) {
            const StageProblem::Evaluation trial = problem.evaluate(x + length * dx, model::HessianKind::none);
            // If the potential cannot resolve the decrease, the residual decides; elsewhere it would allow cycles.
            const bool rounding = -slope < 1e-9 * std::abs(now.potential) || residual < 1e-3;
            const double shrinks = trial.residual.norm() / now.residual.norm();
            accepted = trial.residual.allFinite() &&
                       (conservative
                            ? trial.potential <= now.potential + 1e-4 * length * slope || (rounding && shrinks < 0.9)
                            : shrinks < 1.0 - 1e-4 * length);
            if (accepted) x += length * dx;
        }
        if (!accepted) return false;
        crawling = length < 1e-3 ? crawling + 1 : 0;
    }
    return false;
}

}  // namespace myo::dynamics
