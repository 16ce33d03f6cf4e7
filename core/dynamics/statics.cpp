#include "dynamics/statics.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/cancellation.hpp"
#include "base/text.hpp"
#include "dynamics/softening.hpp"
#include "dynamics/undeformed.hpp"
#include "material/moduli.hpp"
#include "model/force_element.hpp"

namespace myo::dynamics {

Stage static_stage(const model::Body& body, double time_s) {
    Stage stage;
    stage.time_s = time_s;
    stage.constant = Eigen::Matrix3Xd::Zero(3, body.node_count());
    stage.before_jump = true;
    stage.inertia_at_s = time_s;
    return stage;
}

namespace {

/// Modulus of the first cell as text, e.g. "E = 260000 Pa".
std::string modulus_words(const model::Model& model) {
    return "E = " + format_number(material::young_from_moduli(model.moduli.front()).youngs_modulus_Pa, 3) + " Pa";
}

/// Error message: what was sought, how far the iteration came, and what may help.
std::string failure_words(const StageSolver& solver, const StageReport& report) {
    std::string text = "no equilibrium was found under gravity, the loads and the activations at the start: after " +
                       std::to_string(report.newton_iterations) + " iterations ";
    text += std::isfinite(report.residual)
                ? "the forces that are left over are " + format_number(report.residual, 2) + " times those on the body"
                : "the forces on the body are not finite, for it is torn or turned inside out";
    return text + ". Check the units of the modulus (" + modulus_words(solver.model()) +
           "), of density, gravity and loads; smaller loads or a finer mesh may help";
}

struct LoadSteppingPolicy {
    double first_step = 0.25;  // of the commands
    double least_step = 0.02;  // of the commands; the pressure at which no equilibrium was found is as exact
    int max_iterations = 15;   // of a step: a neighbouring equilibrium takes five
};
constexpr LoadSteppingPolicy load_stepping_policy;

/// Outcome of load stepping.
struct LoadSteps {
    bool complete = false;
    std::string message;  // why it is not complete
};

/// Follows the equilibrium while the commands of the force elements grow from zero to their values.
///
/// @param x  in: guess; out: equilibrium under the last commands that have one. 3 x n [m]
LoadSteps step_commands(const StageSolver& solver, double time_s, Eigen::Matrix3Xd& x) {
    double reached = 0.0, step = load_stepping_policy.first_step;
    SolverOptions options = solver.options();
    options.strategy = Strategy::newton;
    options.max_newton_iterations = load_stepping_policy.max_iterations;
    const auto solve_at = [&](double factor) {
        const model::Model model = model::with_constant_commands(solver.model(), factor, time_s);
        StageSolver loaded(model, options);
        if (model.softening) loaded.soften(solver.softening());
        Eigen::Matrix3Xd found = x;
        if (!loaded.solve(static_stage(*model.body, time_s), found).ok() || !found.allFinite()) return false;
        x = found;
        return true;
    };
    // Without commands the body may have no equilibrium for other reasons, which the caller reports.
    if (!solve_at(0.0)) return {};
    while (reached < 1.0) {
        const double next = std::min(1.0, reached + step);
        if (solve_at(next)) {
            reached = next;
            continue;
        }
        step *= 0.5;
        if (step < load_stepping_policy.least_step) return {false, collapse_words(solver.model(), next, time_s)};
    }
    return {true, {}};
}

/// Equilibrium for the current (softened) stiffness of the solver.
StageReport find_equilibrium(StageSolver& solver, double time_s, Eigen::Matrix3Xd& x) {
    Stage stage = static_stage(*solver.model().body, time_s);
    Eigen::Matrix3Xd start = x;
    StageReport report = solver.solve(stage, x);
    if (report.ok() || cancellation_requested()) return report;

    if (model::has_commands(solver.model(), time_s)) {
        Eigen::Matrix3Xd loaded = undeformed_near(*solver.model().body, start);
        const LoadSteps stepped = step_commands(solver, time_s, loaded);
        if (stepped.complete) {
            report = solver.solve(stage, loaded);
            x = loaded;
            if (report.ok()) return report;
        } else if (!stepped.message.empty()) {
            report.message = stepped.message;
            x = loaded;
            return report;
        }
    }

    // If forces at the guess are not finite, no iteration can start there: use the undeformed body.
    if (!solver.total_forces(stage, start).allFinite()) start = undeformed_near(*solver.model().body, start);
    x = start;
    // Overdamped motion: implicit steps of a body whose velocity is reset to zero, with inertia 1/h^2 decreasing by 4.
    for (double inertia = 1e5; inertia > 1e-2 && !cancellation_requested(); inertia *= 0.25) {
        stage.inertia_1_s2 = inertia;
        stage.constant = inertia * model::times_mass(x, solver.mass(stage.inertia_at_s));
        solver.solve(stage, x);  // intermediate solutions need not converge
        if (!x.allFinite()) break;
    }
    if (!x.allFinite()) x = start;
    report = solver.solve(static_stage(*solver.model().body, time_s), x);
    if (!report.ok() && !cancellation_requested()) {
        x = undeformed_near(*solver.model().body, start);
        report = solver.solve(static_stage(*solver.model().body, time_s), x);
    }
    if (!report.ok()) report.message = failure_words(solver, report);
    return report;
}

}  // namespace

void add_work(const StageReport& before, StageReport& report) {
    report.newton_iterations += before.newton_iterations;
    report.linear_iterations += before.linear_iterations;
    report.factorisations += before.factorisations;
    report.times += before.times;
}

std::string collapse_words(const model::Model& model, double part, double time_s) {
    return "no equilibrium was found under " +
           model::command_words(model::with_constant_commands(model, part, time_s), 0.0) +
           (part < 1.0 ? ", less than the " + model::command_words(model, time_s, true) + " of the start" : "") +
           ": beyond it the body gives way; check this command, the mesh and the modulus (" + modulus_words(model) +
           ")";
}

StageReport solve_equilibrium(StageSolver& solver, double time_s, Eigen::Matrix3Xd& x) {
    const std::optional<material::StressSoftening>& softening = solver.model().softening;
    if (!softening) return find_equilibrium(solver, time_s, x);
    // Fixed-point iteration for the softening factors, starting from virgin moduli. Under dead loads the strain grows
    // monotonically, so that each point ends with the factor of its own largest energy.
    solver.soften(Eigen::VectorXd::Ones(solver.model().body->point_count()));
    StageReport report;
    double change = 0.0;
    for (int iteration = 0; iteration < 200; ++iteration) {
        const StageReport before = report;
        report = find_equilibrium(solver, time_s, x);
        add_work(before, report);
        if (!report.ok()) return report;
        Eigen::VectorXd peak;
        raise_peaks(solver.model(), x, peak);
        const Eigen::VectorXd factors = softening_factors(*softening, peak);
        change = (factors - solver.softening()).cwiseAbs().maxCoeff();
        solver.soften(factors);
        if (change < 1e-6) return report;
    }
    report.status = SolveStatus::not_converged;
    report.message =
        "no equilibrium was found under gravity, the loads and the activations at the start: the softening of the "
        "cells still changes by " +
        format_number(change, 2) + " after 200 iterations; smaller loads may help";
    return report;
}

}  // namespace myo::dynamics
