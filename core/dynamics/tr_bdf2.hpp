#pragma once

#include <cmath>
#include <utility>

#include "dynamics/kinematics.hpp"
#include "model/model.hpp"

namespace myo::dynamics {

/// One TR-BDF2 step with gamma = 2 - sqrt(2): second order, L-stable, equal matrices in both stages.
///
/// Returns false if a stage solve failed; `next` is then invalid.
/// Source: Bank et al. 1985; Hosea & Shampine 1996.
template <class Solve>
bool tr_bdf2_step(const StepProblem<Solve>& p, const Kinematics& s, Kinematics& next) {
    const double gamma = 2.0 - std::sqrt(2.0);
    const double d = 0.5 * gamma * p.h;  // both stages have v = x / d + ...
    const double c1 = 1.0 / (gamma * (2.0 - gamma)), c0 = (1.0 - gamma) * (1.0 - gamma) * c1;
    const double lambda = p.velocity_force_1_s;

    // Stage 1, trapezoidal rule over gamma h.
    Stage trapezoid;
    trapezoid.time_s = p.time_s + gamma * p.h;
    trapezoid.inertia_at_s = p.middle_s();
    trapezoid.inertia_1_s2 = 1.0 / (d * d) - lambda / d;
    trapezoid.constant = model::times_mass(s.x / (d * d) + 2.0 / d * s.v - lambda * (s.x / d + s.v), p.mass) + s.force;
    trapezoid.rate_factor_1_s = 1.0 / d;
    trapezoid.rate_history = -s.strain / d - s.rate;
    trapezoid.velocity_history = -s.x / d - s.v;
    StageSolution middle;
    if (!p.solve(trapezoid, middle)) return false;
    const Eigen::Matrix3Xd v1 = (middle.x - s.x) / d - s.v;

    // Stage 2, BDF2 through the start, the middle and the end. With v2 = x2 / d - history the acceleration is
    // (v2 - c1 v1 + c0 v0) / d.
    Stage bdf2;
    const Eigen::Matrix3Xd history = (c1 * middle.x - c0 * s.x) / d;  // v2 = x2 / d - history
    bdf2.time_s = p.time_s + p.h;
    bdf2.inertia_at_s = p.middle_s();
    bdf2.inertia_1_s2 = 1.0 / (d * d) - lambda / d;
    bdf2.constant = model::times_mass(history / d + (c1 * v1 - c0 * s.v) / d - lambda * history, p.mass);
    bdf2.rate_factor_1_s = 1.0 / d;
    bdf2.rate_history = (c0 * s.strain - c1 * middle.strain) / d;
    bdf2.velocity_history = -history;
    StageSolution end;
    if (!p.solve(bdf2, end)) return false;
    next.v = end.x / d - history;
    next.force = model::times_mass((next.v - c1 * v1 + c0 * s.v) / d, p.mass);
    next.rate = std::move(bdf2.rate_history);  // in place: the vectors have one entry per strain measure of all points
    next.rate += end.strain / d;
    next.x = std::move(end.x);
    next.strain = std::move(end.strain);
    return true;
}

}  // namespace myo::dynamics
