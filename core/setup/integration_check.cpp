#include "setup/integration_check.hpp"

#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "dynamics/linearised_step.hpp"
#include "dynamics/material_damping.hpp"
#include "dynamics/natural_modes.hpp"
#include "dynamics/numerical_damping.hpp"

namespace myo::setup {
namespace {

struct IntegrationCheckPolicy {
    /// Numerical damping below this ratio is hard to see: it halves an amplitude in 22 periods.
    double visible_damping_ratio = 0.005;
};
constexpr IntegrationCheckPolicy integration_check_policy;

std::string step_text(double h_s) { return "h = " + format_number(1e3 * h_s, 4) + " ms"; }

/// Critical velocity force of the structure; if the power iteration does not converge, of its first mode alone.
void set_critical_velocity_force(dynamics::StageSolver& solver, const dynamics::TimeScheme& scheme, double omega,
                                 IntegrationCheck& check) {
    const dynamics::CriticalVelocityForce found = dynamics::critical_velocity_force(
        solver, solver.model().body->mesh.nodes, 0.0, scheme, check.h_s);
    check.of_one_mode = found.status != dynamics::SolveStatus::converged || !std::isfinite(found.velocity_force_1_s);
    if (!check.of_one_mode)
        check.critical_velocity_force_1_s = found.velocity_force_1_s;
    else
        check.critical_velocity_force_1_s = dynamics::critical_velocity_force(scheme, omega, check.h_s,
                                                                              check.damping_ratio);
}

}  // namespace

IntegrationCheck check_integration(const model::Model& model, const dynamics::TimeScheme& scheme, double h_s) {
    IntegrationCheck check;
    check.h_s = h_s;
    dynamics::StageSolver solver(model);
    const dynamics::NaturalModes modes = dynamics::natural_modes(solver, model.body->mesh.nodes, 1);
    // A body without modes (not held) has no time scale to judge the step by.
    if (!modes.ok()) return check;
    // The slowest mode decides: markers show it best.
    const double omega = modes.modes.front().omega_rad_s, lambda = model.velocity_force_1_s;
    check.frequency_Hz = omega / (2.0 * std::numbers::pi);
    check.damping_factor = dynamics::damping_factor(model, model.body->mesh.nodes, modes.modes.front());
    check.damping_ratio = dynamics::damping_ratio(check.damping_factor, model.damping_s, omega);
    check.numerical_damping_ratio = dynamics::discrete_vibration(scheme, {omega}, h_s).damping_ratio;
    // The critical value costs a power iteration on the structure and is only needed for a positive velocity force.
    if (lambda > 0.0) {
        set_critical_velocity_force(solver, scheme, omega, check);
        if (lambda > *check.critical_velocity_force_1_s)
            check.warnings.push_back("the velocity force Λ = " + format_number(lambda, 4) +
                                     " 1/s is above Λ_crit = " + format_number(*check.critical_velocity_force_1_s, 4) +
                                     " 1/s of this body at " + step_text(h_s) +
                                     ", so that its motion will grow without bound; try a smaller Λ, or none with " +
                                     to_string(dynamics::Integrator::tr_bdf2));
    }
    // A velocity force feeds energy back and cancels part of the numerical damping; only the remainder is lost.
    const double lost = check.numerical_damping_ratio - 0.5 * lambda / omega;
    if (lost > integration_check_policy.visible_damping_ratio && lost > check.damping_ratio)
        check.warnings.push_back(
            to_string(scheme.integrator) + " at " + step_text(h_s) + " damps the first vibration (" +
            format_number(check.frequency_Hz, 3) + " Hz) by a ratio of " + format_number(lost, 3) +
            ", more than the material's " + format_number(check.damping_ratio, 3) + "; try a smaller step" +
            (scheme.integrator == dynamics::Integrator::tr_bdf2 ? ""
                                                                : ", or " + to_string(dynamics::Integrator::tr_bdf2)));
    return check;
}

}  // namespace myo::setup
