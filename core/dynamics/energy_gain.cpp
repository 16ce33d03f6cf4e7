#include "dynamics/energy_gain.hpp"

#include <cmath>

#include "dynamics/creep.hpp"
#include "dynamics/energy.hpp"

namespace myo::dynamics {

bool gains_energy(const StageSolver& solver, const Kinematics& from, const Kinematics& to, double from_s, double to_s) {
    const model::Model& model = solver.model();
    if (model.velocity_force_1_s > 0.0 ||
        model::activations(model, 0.5 * (from_s + to_s)) != model::activations(model, to_s, true))
        return false;
    // A force that grows does work that an energy with the force of one instant misses.
    for (const model::DeadForce& force : model.forces)
        if (!force.switches() && force.course.value(from_s) != force.course.value_before(to_s)) return false;
    for (const model::ForceElementPointer& element : model.force_elements)
        if (!element->steady(from_s, to_s)) return false;
    const auto energy_at = [&](const Kinematics& s) {
        Energy result = energy(model, solver.stiffness(), solver.mass(0.5 * (from_s + to_s)), s.x, s.v, to_s, true);
        if (model.creep) result.internal_J += branch_energy(model, s.x, s.strain);
        return result;
    };
    const Energy before = energy_at(from), after = energy_at(to);
    const double moved = before.kinetic_J + after.kinetic_J + std::abs(after.internal_J - before.internal_J);
    // A body at rest moves within the solver tolerance, which is no gain of energy.
    const double noise = 1e-9 * (std::abs(before.internal_J) + std::abs(before.work_J));
    return after.total_J() - before.total_J() > 0.02 * moved + noise;  // false if an energy is NaN
}

}  // namespace myo::dynamics
