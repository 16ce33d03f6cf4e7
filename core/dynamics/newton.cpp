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
    // Of many columns every iteration is dear, and those of a factor of this very matrix are some fewer.
    const bool pays = B.cols() > factor.iterations_per_factorisation(body);
    if (pays || factor.is_stale(problem.stage().inertia_1_s2)) {
        if (!factor.renew_with(H, problem, x, report)) return false;
        fresh = true;
    } else {
        factor.turn_to(body, x);
    }
    while (true) {
        const int limit = std::max(factor.is_whole(body.pattern) ? 30 : 500, factor.iterations_per_factorisation(body));
        const solver::ConjugateGradientReport cg = solver::conjugate_gradient(product, metric, B, tolerance, limit,
                                                                              guess);
        report.linear_iterations += cg.iterations;
        if (cg.converged) {
            factor.charge(cg.iterations, body);
            solution = cg.solution;
            return true;
        }
        if (fresh || !factor.renew_with(H, problem, x, report)) return false;
        fresh = true;
    }
}

bool mixed_newton(const StageProblem& problem, const SolverOptions& options, double scale, LaggedFactor& factor,
                  Matrix3Xd& x, StageReport& report) {
    const model::Model& model = problem.model();
    const model::Stiffness& stiffness = problem.constants().stiffness;
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
        // A tolerance below rounding: the residual has stopped falling far below anything physical.
        const bool at_rounding = without_progress >= 2 && best_residual < 1e-9;
        if (residual <= options.tolerance || at_rounding) {
            x = best;
            return true;
        }
        if (without_progress > 6) break;
        MatrixXd step;
        const double accuracy = std::clamp(0.1 * residual, 1e-6, 1e-2);
        if (!solve_by_lagged_factor(now.hessian, -now.residual, accuracy, problem, x, factor, report, step)) {
            if (kind != model::HessianKind::exact || model.fibres->empty()) break;
            kind = model::HessianKind::positive_fibres;  // muscles that push make the exact one indefinite
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

/// Factors the exact Hessian or, where it is not definite or lately was not, that of positive fibres or of positive
/// cells. `hessian`: the exact one, on return the one that was factored. `indefinite`: steps still to be taken without
/// the exact one.
static bool factor_definite(const StageProblem& problem, const Matrix3Xd& x, int& indefinite, LaggedFactor& factor,
                            solver::SymmetricSparse& hessian, StageReport& report) {
    if (indefinite == 0 && factor.renew_with(hessian, problem, x, report)) return true;
    indefinite = indefinite > 0 ? indefinite - 1 : 1;  // where one Hessian was indefinite the next one mostly is
    if (!problem.model().fibres->empty()) {
        hessian = problem.evaluate(x, model::HessianKind::positive_fibres).hessian;
        if (factor.renew_with(hessian, problem, x, report)) return true;
    }
    hessian = problem.evaluate(x, model::HessianKind::positive).hessian;
    // Positive cells leave motions without any stiffness, along which a step would know no end: a small shift along the
    // mass.
    const solver::SymmetricSparse& inertia = problem.inertia();
    hessian.coeffs() += 1e-6 * hessian.diagonal().sum() / inertia.diagonal().sum() * inertia.coeffs();
    return factor.renew_with(hessian, problem, x, report);
}

bool energy_newton(const StageProblem& problem, const SolverOptions& options, double scale, LaggedFactor& factor,
                   Matrix3Xd& x, StageReport& report) {
    int indefinite = 0;  // steps still to be taken with positive cells
    int crawling = 0;    // steps in a row of less than a thousandth of what was asked for
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
        const double slope = now.residual.dot(step.col(0));
        if (!(slope < 0.0)) return false;
        const Matrix3Xd dx = model::scatter(problem.pattern(), step);
        double length = 1.0;
        bool accepted = false;
        for (int halving = 0; halving < 40 && !accepted; ++halving, length *= 0.5) {
            const StageProblem::Evaluation trial = problem.evaluate(x + length * dx, model::HessianKind::none);
            // Below rounding of the potential the residual decides; above it, it would lead round in circles.
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
