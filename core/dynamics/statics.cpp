#include "dynamics/statics.hpp"

#include "dynamics/undeformed.hpp"

namespace myo {

Stage static_stage(const Body& body, double time_s) {
    Stage stage;
    stage.time_s = time_s;
    stage.constant = Eigen::Matrix3Xd::Zero(3, body.node_count());
    stage.before_jump = true;
    return stage;
}

StageReport solve_equilibrium(StageSolver& solver, double time_s, Eigen::Matrix3Xd& x) {
    Stage stage = static_stage(*solver.model().body, time_s);
    Eigen::Matrix3Xd start = x;
    StageReport report = solver.solve(stage, x);
    if (report.ok()) return report;

    // A start without forces leads nowhere; nothing of it is worth keeping.
    if (!solver.total_forces(stage, start).allFinite()) start = undeformed_near(*solver.model().body, start);
    x = start;
    for (double inertia = 1e5; inertia > 1e-2; inertia *= 0.25) {
        stage.inertia_1_s2 = inertia;
        stage.constant = inertia * times_mass(x, solver.mass());
        solver.solve(stage, x);   // only the last one has to converge
        if (!x.allFinite()) break;
    }
    if (!x.allFinite()) x = start;
    report = solver.solve(static_stage(*solver.model().body, time_s), x);
    if (!report.ok()) {
        x = undeformed_near(*solver.model().body, start);
        report = solver.solve(static_stage(*solver.model().body, time_s), x);
    }
    if (!report.ok()) report.message = "no equilibrium was found: " + report.message;
    return report;
}

}  // namespace myo
