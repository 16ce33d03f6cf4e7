#pragma once

#include <utility>

#include "dynamics/kinematics.hpp"
#include "model/model.hpp"

namespace myo::dynamics {

/// One implicit Euler step: x1 = x0 + h v1, M (v1 - v0)/h = F(x1) + Lambda M v0.
///
/// The velocity force Lambda M v0 uses the velocity at the start of the step, as in the paper (eqs. 3 and 10).
/// @param p     mass, time, h and stage solver
/// @param s     state at the start of the step; its force and rate are not used
/// @param next  state at the end; valid only if the step succeeds
/// @return      false if the stage solve failed
template <class Solve>
bool implicit_euler_step(const StepProblem<Solve>& p, const Kinematics& s, Kinematics& next) {
    Stage stage;
    stage.time_s = p.time_s + p.h;
    stage.inertia_at_s = p.middle_s();
    stage.inertia_1_s2 = 1.0 / (p.h * p.h);
    stage.constant = model::times_mass(stage.inertia_1_s2 * s.x + (1.0 / p.h + p.velocity_force_1_s) * s.v, p.mass);
    stage.rate_factor_1_s = 1.0 / p.h;
    stage.rate_history = -s.strain / p.h;
    stage.velocity_history = -s.x / p.h;
    StageSolution end;
    if (!p.solve(stage, end)) return false;
    next.v = (end.x - s.x) / p.h;
    next.force = model::times_mass((next.v - s.v) / p.h, p.mass);
    next.rate = (end.strain - s.strain) / p.h;
    next.x = std::move(end.x);
    next.strain = std::move(end.strain);
    return true;
}

}  // namespace myo::dynamics
