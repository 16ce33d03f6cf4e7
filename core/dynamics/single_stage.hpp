#pragma once

#include <type_traits>
#include <utility>

#include "dynamics/kinematics.hpp"
#include "model/model.hpp"

namespace myo::dynamics {

/// Coefficients of a scheme with one stage per step.
///
/// The scheme treats positions, momenta and strains in the same way: for a quantity y with derivative D and stored
/// slope y',
///   D1  = change (y1 - y0) - slope y'0 - derivative D0,
///   y'1 = next_change (y1 - y0) - next_slope y'0.
struct StepFormula {
    double change_1_s = 0.0;
    double slope = 0.0;
    double derivative = 0.0;
    double next_change_1_s = 0.0;
    double next_slope = 0.0;
};

/// One step of the scheme. D1 of the momenta is the total force at the end of the step, velocity force included.
///
/// Returns false if the stage solve failed; `next` is then invalid.
template <class Solve>
bool single_stage_step(const StepProblem<Solve>& p, const StepFormula& f, const Kinematics& s, Kinematics& next) {
    const double q = f.change_1_s, lambda = p.velocity_force_1_s;
    const auto slope_of = [](const auto& derivative, const auto& lag) {
        return lag.size() == 0 ? derivative : std::decay_t<decltype(derivative)>(derivative + lag);
    };
    const Eigen::Matrix3Xd x_slope = slope_of(s.v, s.v_lag), momentum_slope = slope_of(s.force, s.force_lag);
    const Eigen::VectorXd strain_slope = slope_of(s.rate, s.rate_lag);
    const Eigen::Matrix3Xd v_history = f.slope * x_slope + f.derivative * s.v;  // v1 = q (x1 - x0) - v_history
    const Eigen::Matrix3Xd force_history = f.slope * momentum_slope +
                                           f.derivative * s.force;  // M a1 = q M (v1 - v0) - force_history
    const Eigen::VectorXd rate_history = f.slope * strain_slope + f.derivative * s.rate;

    // Substituting v1 and M a1 into M a1 = F + Lambda M v1 gives the inertia factor q^2 - Lambda q and the constant.
    Stage stage;
    stage.time_s = p.time_s + p.h;
    stage.inertia_at_s = p.middle_s();
    stage.inertia_1_s2 = q * q - lambda * q;
    stage.constant = model::times_mass(stage.inertia_1_s2 * s.x + (q - lambda) * v_history + q * s.v, p.mass) +
                     force_history;
    stage.rate_factor_1_s = q;
    stage.rate_history = -q * s.strain - rate_history;
    stage.velocity_history = -q * s.x - v_history;
    StageSolution end;
    if (!p.solve(stage, end)) return false;

    const Eigen::Matrix3Xd moved = end.x - s.x;
    const Eigen::VectorXd strained = end.strain - s.strain;
    next.v = q * moved - v_history;
    const Eigen::Matrix3Xd gained = model::times_mass(next.v - s.v, p.mass);
    next.force = q * gained - force_history;
    next.rate = q * strained - rate_history;
    // Memory is stored relative to the derivatives, see Kinematics.
    next.v_lag = f.next_change_1_s * moved - f.next_slope * x_slope - next.v;
    next.force_lag = f.next_change_1_s * gained - f.next_slope * momentum_slope - next.force;
    next.rate_lag = f.next_change_1_s * strained - f.next_slope * strain_slope - next.rate;
    next.step_before_s = p.h;
    next.x = std::move(end.x);
    next.strain = std::move(end.strain);
    return true;
}

}  // namespace myo::dynamics
