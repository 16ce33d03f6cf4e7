#include "dynamics/linearised_step.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "dynamics/creep.hpp"
#include "dynamics/natural_modes.hpp"
#include "dynamics/statics.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

void scale(Kinematics& s, double factor) {
    for (Matrix3Xd* part : {&s.x, &s.v, &s.force, &s.v_lag, &s.force_lag}) *part *= factor;
    for (VectorXd* part : {&s.strain, &s.rate, &s.rate_lag}) *part *= factor;
}

}  // namespace

LinearisedStep::LinearisedStep(StageSolver& solver, Matrix3Xd x, double time_s, const TimeScheme& scheme, double h_s,
                               double velocity_force_1_s)
    : solver_(&solver),
      x_(std::move(x)),
      time_s_(time_s),
      scheme_(scheme),
      h_s_(h_s),
      velocity_force_1_s_(velocity_force_1_s) {}

const LinearisedStep::LinearStage& LinearisedStep::linear_stage(const Stage& stage) {
    // The two stages of a step usually have the same matrix; it is assembled once.
    for (const LinearStage& known : stages_)
        if (known.stage.inertia_1_s2 == stage.inertia_1_s2 && known.stage.rate_factor_1_s == stage.rate_factor_1_s)
            return known;
    Stage at_rest = static_stage(*solver_->model().body, time_s_);
    at_rest.inertia_1_s2 = stage.inertia_1_s2;
    at_rest.rate_factor_1_s = stage.rate_factor_1_s;
    // The stage represents the body at rest at x: rate and velocity vanish there.
    at_rest.rate_history = -stage.rate_factor_1_s * model::strains(solver_->model(), x_);
    if (solver_->model().creep) at_rest.rate_history = at_rest.rate_history.replicate(2, 1).eval();
    at_rest.velocity_history = -stage.rate_factor_1_s * x_;
    stages_.push_back({at_rest, solver_->hessian(at_rest, x_)});
    return stages_.back();
}

Kinematics LinearisedStep::displaced(const Matrix3Xd& u) {
    const model::Body& body = *solver_->model().body;
    Kinematics s;
    s.x = u;
    s.v = Matrix3Xd::Zero(3, u.cols());
    // Force of the displaced body at rest: -K u.
    const solver::SymmetricSparse K = solver_->hessian(static_stage(body, time_s_), x_);
    s.force = model::scatter(body.pattern, -(K.selfadjointView<Eigen::Lower>() * model::gather(body.pattern, u)));
    s.strain = model::strain_tangent(solver_->model(), x_, u);
    if (solver_->model().creep) s.strain = s.strain.replicate(2, 1).eval();
    s.rate = VectorXd::Zero(s.strain.size());
    return s;
}

Kinematics LinearisedStep::apply(const Kinematics& deviation) {
    const model::Model& model = solver_->model();
    const model::BlockPattern& pattern = model.body->pattern;
    const auto solve = [&](const Stage& stage, StageSolution& solution) {
        // The deviations of strain rates and velocities have an explicit part, the history, which acts as a load.
        Matrix3Xd load = stage.constant;
        if (model.creep)
            load -= model::viscous_gradient(model, x_,
                                            viscous_history(model, stage.rate_factor_1_s, stage.rate_history));
        else if (model::is_viscous(model))
            load -= model::viscous_gradient(model, x_, stage.rate_history);
        const LinearStage& linear = linear_stage(stage);
        if (model::depends_on_velocity(model)) {
            const Matrix3Xd v = stage_velocities(linear.stage, x_);
            load -= model::velocity_tangent(model, force_state(linear.stage, x_, v), stage.velocity_history);
        }
        solution.x = model::scatter(
            pattern, solver_->solve_linear(linear.hessian, linear.stage, x_, model::gather(pattern, load)));
        solution.strain = model::strain_tangent(model, x_, solution.x);
        if (model.creep)
            solution.strain = with_dashpots(*model.creep, stage.rate_factor_1_s, solution.strain, stage.rate_history);
        return true;
    };
    const StepProblem<decltype(solve)> problem{solver_->mass(time_s_), time_s_, h_s_, velocity_force_1_s_, solve};
    Kinematics next;
    take_step(scheme_, problem, deviation, next);
    return next;
}

GrowthPerStep growth_per_step(LinearisedStep& step, const Matrix3Xd& start, int max_steps) {
    const model::BlockPattern& pattern = step.solver().model().body->pattern;
    // Displacements alone would be parallel for a single mode, and any two components satisfy some recurrence from the
    // first step on. Velocity and memory are included so that the parasitic roots of two-step schemes must have
    // decayed.
    const auto observed = [&](const Kinematics& s) {
        const Matrix3Xd lag = s.v_lag.size() > 0 ? s.v_lag : Matrix3Xd::Zero(3, s.v.cols());
        VectorXd y(3 * pattern.unknowns());
        y << model::gather(pattern, s.x), step.h_s() * model::gather(pattern, s.v),
            step.h_s() * model::gather(pattern, lag);
        return y;
    };
    GrowthPerStep result;
    Kinematics state = step.displaced(start);
    VectorXd before = observed(state);
    state = step.apply(state);
    VectorXd now = observed(state);
    for (result.steps = 2; result.steps <= max_steps; ++result.steps) {
        state = step.apply(state);
        const VectorXd next = observed(state);
        const double size = next.norm();
        if (!std::isfinite(size) || size == 0.0) {
            result.status = SolveStatus::not_finite;
            return result;
        }
        Eigen::MatrixXd history(next.size(), 2);
        history << now, before;
        const Eigen::Vector2d c = history.colPivHouseholderQr().solve(next);
        result.residual = (history * c - next).norm() / size;
        // Dominant pair: roots of z^2 = c0 z + c1. Complex: |z|^2 = -c1; real: the larger magnitude.
        const double half = 0.5 * c(0), discriminant = half * half + c(1);
        result.spectral_radius = discriminant < 0.0 ? std::sqrt(-c(1)) : std::abs(half) + std::sqrt(discriminant);
        // The map is linear: normalise to avoid overflow over many steps.
        before = now / size;
        now = next / size;
        scale(state, 1.0 / size);
        result.status = result.residual < 1e-8 ? SolveStatus::converged : SolveStatus::not_converged;
        if (result.status == SolveStatus::converged) return result;
    }
    return result;
}

CriticalVelocityForce critical_velocity_force(StageSolver& solver, const Matrix3Xd& x, double time_s,
                                              const TimeScheme& scheme, double h_s) {
    CriticalVelocityForce result;
    const NaturalModes modes = natural_modes(solver, x, 1, time_s);
    result.status = modes.status;
    if (!modes.ok()) return result;
    result.omega_rad_s = modes.modes.front().omega_rad_s;
    // The squared radius is linear in Lambda for implicit Euler and nearly linear for the others: the secant method
    // converges in a few iterations.
    const auto excess = [&](double lambda) {
        LinearisedStep step(solver, x, time_s, scheme, h_s, lambda);
        const GrowthPerStep growth = growth_per_step(step, modes.modes.front().shape);
        result.steps += growth.steps;
        result.status = growth.status;
        return growth.spectral_radius * growth.spectral_radius - 1.0;
    };
    double low = 0.0, at_low = excess(low);
    double high = 2.0 * std::max(-at_low / h_s, 1e-3 * result.omega_rad_s), at_high = excess(high);
    for (int i = 0; i < 20 && std::abs(high - low) > 1e-9 * result.omega_rad_s && at_high != at_low; ++i) {
        const double next = high - at_high * (high - low) / (at_high - at_low);
        low = high;
        at_low = at_high;
        high = next;
        at_high = excess(high);
    }
    result.velocity_force_1_s = high;
    return result;
}

}  // namespace myo::dynamics
