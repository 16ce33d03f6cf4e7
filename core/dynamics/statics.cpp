#include "dynamics/statics.hpp"

#include <cmath>
#include <optional>

#include "base/text.hpp"
#include "dynamics/softening.hpp"
#include "dynamics/undeformed.hpp"
#include "material/moduli.hpp"

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

/// Equilibrium for the current (softened) stiffness of the solver.
StageReport find_equilibrium(StageSolver& solver, double time_s, Eigen::Matrix3Xd& x) {
    Stage stage = static_stage(*solver.model().body, time_s);
    Eigen::Matrix3Xd start = x;
    StageReport report = solver.solve(stage, x);
    if (report.ok()) return report;

    // If forces at the guess are not finite, no iteration can start there: use the undeformed body.
    if (!solver.total_forces(stage, start).allFinite()) start = undeformed_near(*solver.model().body, start);
    x = start;
    // Overdamped motion: implicit steps of a body whose velocity is reset to zero, with inertia 1/h^2 decreasing by 4.
    for (double inertia = 1e5; inertia > 1e-2; inertia *= 0.25) {
        stage.inertia_1_s2 = inertia;
        stage.constant = inertia * model::times_mass(x, solver.mass(stage.inertia_at_s));
        solver.solve(stage, x);  // intermediate solutions need not converge
        if (!x.allFinite()) break;
    }
    if (!x.allFinite()) x = start;
    report = solver.solve(static_stage(*solver.model().body, time_s), x);
    if (!report.ok()) {
        x = undeformed_near(*solver.model().body, start);
        report = solver.solve(static_stage(*solver.model().body, time_s), x);
    }
    if (!report.ok()) report.message = failure_words(solver, report);
    return report;
}

void add_work(const StageReport& before, StageReport& report) {
    report.newton_iterations += before.newton_iterations;
    report.linear_iterations += before.linear_iterations;
    report.factorisations += before.factorisations;
    report.times += before.times;
}

}  // namespace

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
