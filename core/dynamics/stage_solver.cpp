#include "dynamics/stage_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "solver/conjugate_gradient.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// M (x) I over the free unknowns, stored in the body's pattern.
SymmetricSparse inertia_in_pattern(const Body& body, const Eigen::SparseMatrix<double>& mass) {
    SymmetricSparse inertia = body.pattern.zero;
    for (int column = 0; column < mass.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(mass, column); entry; ++entry) {
            const int i = body.pattern.free_index[static_cast<std::size_t>(entry.row())];
            const int j = body.pattern.free_index[static_cast<std::size_t>(column)];
            if (j < 0 || i < j) continue;
            for (int r = 0; r < 3; ++r) inertia.coeffRef(3 * i + r, 3 * j + r) += entry.value();
        }
    return inertia;
}

VectorXd multiply(const SymmetricSparse& lower, const VectorXd& v) { return lower.selfadjointView<Eigen::Lower>() * v; }

/// Conjugate-gradient iterations that cost as much as one factorisation. A factorisation runs at the speed of dense products,
/// a solve at the speed of memory: measured 20 and 1.5 Gflop/s on one core (4,608 unknowns: 27 ms and 0.72 ms).
int iterations_per_factorisation(const SparseCholesky& factor, const SymmetricSparse& H) {
    const double factorisation = factor.factor_flops() / 20.0;
    const double iteration = (4.0 * factor.factor_entries() + 4.0 * static_cast<double>(H.nonZeros())) / 1.5;
    return std::max(4, static_cast<int>(factorisation / iteration));
}

}  // namespace

StageSolver::StageSolver(const Model& model, SolverOptions options)
    : model_(&model),
      options_(options),
      mass_(mass_matrix(model)),
      inertia_(inertia_in_pattern(*model.body, mass_)),
      stiffness_(stiffness(model)) {}

StageSolver::Evaluation StageSolver::evaluate(const Stage& stage, const Matrix3Xd& x, HessianKind kind, const VectorXd* pressure) {
    const BlockPattern& pattern = model_->body->pattern;
    const std::vector<double> activation = activations(*model_, stage.time_s, stage.before_jump);
    InternalInput input;
    input.stiffness = &stiffness_;
    input.activation = &activation;
    if (stage.rate_history.size() > 0) input.rate = {stage.rate_factor_1_s, &stage.rate_history};
    input.pressure = pressure;
    InternalEnergy internal = internal_energy(*model_, x, input, kind);

    const Matrix3Xd dead = stage.constant + external_forces(*model_, mass_, stage.time_s, stage.before_jump);
    const Matrix3Xd momentum = stage.inertia_1_s2 * (x * mass_);
    Evaluation result;
    result.potential = internal.energy + (0.5 * momentum - dead).cwiseProduct(x).sum();
    result.residual = gather(pattern, momentum + internal.gradient - dead);
    if (kind != HessianKind::none) {
        result.hessian = std::move(internal.hessian);
        result.hessian.coeffs() += stage.inertia_1_s2 * inertia_.coeffs();
    }
    return result;
}

double StageSolver::force_scale(const Stage& stage, const Matrix3Xd& start) const {
    const BlockPattern& pattern = model_->body->pattern;
    const double external = gather(pattern, external_forces(*model_, mass_, stage.time_s, stage.before_jump)).norm();
    const double inertial = gather(pattern, stage.constant - stage.inertia_1_s2 * (start * mass_)).norm();
    // A body at rest without any force still needs a scale: a millionth of the force that strains it by one.
    const double volume = model_->body->unit_mass.sum();
    const double elastic = 1e-6 * model_->moduli.front().mu * std::cbrt(volume * volume);
    return std::max({external + inertial, elastic, rounding_of_forces(stage, start) / options_.tolerance, 1e-30});
}

/// Norm below which the residual is noise: F is known to eps |x| / edge, which the bulk modulus turns into a nodal force over
/// edge^2, and the inertia of a short step multiplies eps |x| too; n nodes add as sqrt(n). Without it free vibrations at
/// nu = 0.499 stall at tolerances of 1e-8 (implicit Euler, whose first force after a release is small) and 1e-9.
double StageSolver::rounding_of_forces(const Stage& stage, const Matrix3Xd& x) const {
    const Body& body = *model_->body;
    const double extent = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff() + x.rowwise().mean().norm();
    const double edge = std::cbrt(body.unit_mass.sum() / body.cell_count());
    double stiffest = 0.0;
    for (const Moduli& m : model_->moduli) stiffest = std::max({stiffest, m.kappa, m.mu});
    const double inertia = std::abs(stage.inertia_1_s2) * mass_.sum() / body.node_count();
    return std::numeric_limits<double>::epsilon() * extent * (stiffest * edge + inertia) * std::sqrt(static_cast<double>(body.node_count()));
}

bool StageSolver::renew_factor(const SymmetricSparse& H, StageReport& report) {
    ++report.factorisations;
    extra_iterations_ = 0;
    return factor_.factorize(H);
}

bool StageSolver::factor_is_stale() const {
    return !factor_.has_factor() || extra_iterations_ > iterations_per_factorisation(factor_, inertia_);
}

bool StageSolver::solve_step(const SymmetricSparse& H, const VectorXd& b, double tolerance, VectorXd& step, StageReport& report) {
    const auto apply = [&](const VectorXd& v) { return multiply(H, v); };
    const auto precondition = [&](const VectorXd& v) { return VectorXd(factor_.solve(v)); };
    bool fresh = false;
    if (factor_is_stale()) {
        if (!renew_factor(H, report)) return false;
        fresh = true;
    }
    while (true) {
        const int limit = std::max(30, iterations_per_factorisation(factor_, H));
        const ConjugateGradientReport cg = conjugate_gradient(apply, precondition, b, tolerance, limit);
        report.linear_iterations += cg.iterations;
        if (cg.converged) {
            extra_iterations_ += std::max(0, cg.iterations - 2);
            step = cg.solution;
            return true;
        }
        if (fresh) return false;
        if (!renew_factor(H, report)) return false;
        fresh = true;
    }
}

bool StageSolver::pressure_newton(const Stage& stage, double scale, Matrix3Xd& x, StageReport& report) {
    const BlockPattern& pattern = model_->body->pattern;
    VectorXd pressure = pressures(*model_, x);
    Matrix3Xd best = x;
    double best_residual = std::numeric_limits<double>::infinity();
    int without_progress = 0;
    for (; report.newton_iterations < options_.max_newton_iterations; ++report.newton_iterations) {
        const Evaluation now = evaluate(stage, x, HessianKind::exact, &pressure);
        const double residual = now.residual.norm() / scale;
        if (!std::isfinite(residual)) break;
        if (residual < 0.5 * best_residual) without_progress = 0;
        else ++without_progress;
        if (residual < best_residual) {
            best_residual = residual;
            best = x;
        }
        report.residual = best_residual;
        // A tolerance below rounding: the residual has stopped falling far below anything physical.
        const bool at_rounding = without_progress >= 2 && best_residual < 1e-9;
        if (residual <= options_.tolerance || at_rounding) {
            x = best;
            report.status = SolveStatus::converged;
            return true;
        }
        if (without_progress > 6) break;
        VectorXd step;
        const double accuracy = std::clamp(0.1 * residual, 1e-6, 1e-2);
        if (!solve_step(now.hessian, -now.residual, accuracy, step, report)) break;
        const Matrix3Xd dx = scatter(pattern, step);
        pressure = predicted_pressures(*model_, x, dx);
        if (!pressure.allFinite()) break;
        x += dx;
    }
    x = best;
    report.residual = best_residual;
    return false;
}

bool StageSolver::energy_newton(const Stage& stage, double scale, Matrix3Xd& x, StageReport& report) {
    const BlockPattern& pattern = model_->body->pattern;
    const int last = report.newton_iterations + 5 * options_.max_newton_iterations;
    for (; report.newton_iterations < last; ++report.newton_iterations) {
        Evaluation now = evaluate(stage, x, HessianKind::exact, nullptr);
        const double residual = now.residual.norm() / scale;
        report.residual = residual;
        if (!std::isfinite(residual)) {
            report.status = SolveStatus::not_finite;
            return false;
        }
        if (residual <= options_.tolerance) {
            report.status = SolveStatus::converged;
            return true;
        }
        if (!renew_factor(now.hessian, report)) {
            now.hessian = evaluate(stage, x, HessianKind::positive, nullptr).hessian;
            // Statics of a body with a zero mode still needs a definite matrix: a small shift along the mass.
            if (!renew_factor(now.hessian, report)) {
                now.hessian.coeffs() += 1e-6 * now.hessian.diagonal().sum() / inertia_.diagonal().sum() * inertia_.coeffs();
                if (!renew_factor(now.hessian, report)) return false;
            }
        }
        const VectorXd step = -factor_.solve(now.residual);
        const double slope = now.residual.dot(step);
        const Matrix3Xd dx = scatter(pattern, step);
        double length = 1.0;
        bool accepted = false;
        for (int halving = 0; halving < 40 && !accepted; ++halving, length *= 0.5) {
            const Evaluation trial = evaluate(stage, x + length * dx, HessianKind::none, nullptr);
            // Below rounding of the potential the residual decides.
            accepted = trial.residual.allFinite() && (trial.potential <= now.potential + 1e-4 * length * slope ||
                                                      trial.residual.norm() < 0.9 * now.residual.norm());
            if (accepted) x += length * dx;
        }
        if (!accepted) return false;
    }
    return false;
}

StageReport StageSolver::solve(const Stage& stage, Matrix3Xd& x) {
    // Both stages of a step share their inertia; another one (a shortened step, statics) needs another factor.
    if (stage.inertia_1_s2 != factored_inertia_) {
        extra_iterations_ = std::numeric_limits<int>::max() / 2;
        factored_inertia_ = stage.inertia_1_s2;
    }
    StageReport report;
    const double scale = force_scale(stage, x);
    if (pressure_newton(stage, scale, x, report)) return report;
    extra_iterations_ = std::numeric_limits<int>::max() / 2;
    if (energy_newton(stage, scale, x, report)) {
        extra_iterations_ = std::numeric_limits<int>::max() / 2;
        return report;
    }
    extra_iterations_ = std::numeric_limits<int>::max() / 2;
    if (report.status == SolveStatus::not_run) report.status = SolveStatus::not_converged;
    report.message = "the step did not converge: after " + std::to_string(report.newton_iterations) +
                     " Newton iterations the residual is " + format_number(report.residual, 2) + " of the forces on the body";
    return report;
}

SymmetricSparse StageSolver::hessian(const Stage& stage, const Matrix3Xd& x) {
    return evaluate(stage, x, HessianKind::exact, nullptr).hessian;
}

VectorXd StageSolver::solve_linear(const SymmetricSparse& H, const VectorXd& b) {
    StageReport unused;
    VectorXd solution;
    if (b.isZero(0.0)) return VectorXd::Zero(b.size());
    if (solve_step(H, b, options_.tangent_tolerance, solution, unused)) return solution;
    // An indefinite Hessian at a converged state (a buckling body): solved with the fresh factor as far as it goes.
    SparseCholesky exact;
    if (exact.factorize(H)) return exact.solve(b);
    return VectorXd::Constant(b.size(), std::numeric_limits<double>::quiet_NaN());
}

Matrix3Xd StageSolver::total_forces(const Stage& stage, const Matrix3Xd& x) {
    Stage without_inertia = stage;
    without_inertia.inertia_1_s2 = 0.0;
    without_inertia.constant = Matrix3Xd::Zero(3, x.cols());
    return scatter(model_->body->pattern, -evaluate(without_inertia, x, HessianKind::none, nullptr).residual);
}

}  // namespace myo
