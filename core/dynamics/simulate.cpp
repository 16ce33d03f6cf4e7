#include "dynamics/simulate.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/extrapolation.hpp"
#include "dynamics/statics.hpp"

namespace myo {
namespace {

/// Step ends in (0, end]: the jumps, and the multiples of h that are not just beside one. A step much shorter than h would
/// turn the rounding of positions into accelerations.
std::vector<double> step_ends(const Model& model, double h, double end) {
    std::vector<double> ends;
    for (const double t : jump_times(model))
        if (t > 1e-6 * h && t < end) ends.push_back(t);
    const std::vector<double> jumps = ends;
    const auto count = static_cast<long>(std::ceil(end / h - 1e-9));
    for (long k = 1; k <= count; ++k) {
        const double t = static_cast<double>(k) * h, beside = k < count ? 0.05 * h : 1e-6 * h;
        if (std::none_of(jumps.begin(), jumps.end(), [&](double jump) { return std::abs(jump - t) <= beside; })) ends.push_back(t);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<double> merged;   // jumps within rounding of each other are one, the last
    for (const double t : ends) {
        if (!merged.empty() && t - merged.back() <= 1e-6 * h) merged.pop_back();
        merged.push_back(t);
    }
    return merged;
}

bool is_jump(const std::vector<double>& jumps, double t, double h) {
    return std::any_of(jumps.begin(), jumps.end(), [&](double jump) { return std::abs(jump - t) <= 1e-6 * h; });
}

void count(const StageReport& report, Trace& trace) {
    ++trace.stages;
    trace.newton_iterations += report.newton_iterations;
    trace.linear_iterations += report.linear_iterations;
    trace.factorisations += report.factorisations;
    trace.times += report.times;
}

std::string where_it_failed(double t, double h, const std::string& reason) {
    return "at t = " + std::to_string(t) + " s (h = " + std::to_string(h) + " s) " + reason + "; try a smaller step";
}

}  // namespace

Stage jump_stage(const Kinematics& state, double time_s) {
    Stage stage;
    stage.time_s = time_s;
    stage.constant = Eigen::Matrix3Xd::Zero(3, state.x.cols());
    stage.rate_history = state.rate;
    return stage;
}

Trace simulate(const Model& model, const SimulationOptions& options, const Progress& progress, const RunObserver& observer) {
    StageSolver solver(model, options.solver);
    const Body& body = *model.body;
    Trace trace;
    Kinematics state;
    state.x = body.mesh.nodes;
    state.v = Eigen::Matrix3Xd::Zero(3, body.node_count());
    if (options.start == StartKind::equilibrium) {
        const StageReport report = solve_equilibrium(solver, 0.0, state.x);
        count(report, trace);
        if (!report.ok()) {
            trace.status = RunStatus::failed;
            trace.message = report.message;
            return trace;
        }
    }
    state.strain = strains(body, state.x);
    state.rate = Eigen::VectorXd::Zero(state.strain.size());
    if (observer.started) observer.started(solver, state);

    const auto record = [&](double t) {
        trace.times_s.push_back(t);
        trace.positions.push_back(state.x);
        trace.velocities.push_back(state.v);
    };
    const auto set_force = [&](double t) {
        state.force = solver.total_forces(jump_stage(state, t), state.x) + model.velocity_force_1_s * times_mass(state.v, solver.mass());
        if (observer.jumped) observer.jumped(solver, state, t);
    };
    record(0.0);
    const std::vector<double> ends = step_ends(model, options.h_s, options.end_s);
    const std::vector<double> jumps = jump_times(model);
    // A jump within rounding of the start belongs to the start.
    double loads_from = 0.0;
    for (const double jump : jumps)
        if (jump > 0.0 && jump <= 1e-6 * options.h_s) loads_from = jump;
    set_force(loads_from);
    Extrapolation past;
    past.restart(0.0, state.x);
    double t = 0.0;
    for (std::size_t k = 0; k < ends.size(); ++k) {
        if (progress.cancelled()) {
            trace.status = RunStatus::cancelled;
            trace.message = "stopped at t = " + std::to_string(t) + " s";
            return trace;
        }
        const double h = ends[k] - t;
        const bool jump_at_end = is_jump(jumps, ends[k], options.h_s);
        std::vector<SolvedStage> solved;
        StageReport last;
        const auto solve = [&](Stage& stage, StageSolution& solution) {
            if (std::abs(stage.time_s - ends[k]) < 1e-9 * h) stage.time_s = ends[k];
            stage.before_jump = jump_at_end && stage.time_s == ends[k];
            const auto without_past = [&]() -> Eigen::Matrix3Xd {
                return solved.empty() ? Eigen::Matrix3Xd(state.x + (stage.time_s - t) * state.v) : solved.back().solution.x;
            };
            const std::optional<Eigen::Matrix3Xd> continued = past.at(stage.time_s);
            solution.x = continued ? *continued : without_past();
            for (int i = 0; i < body.node_count(); ++i)
                if (body.clamped[static_cast<std::size_t>(i)]) solution.x.col(i) = body.mesh.nodes.col(i);
            last = solver.solve(stage, solution.x);
            count(last, trace);
            if (!last.ok()) return false;
            solution.strain = strains(body, solution.x);
            past.add(stage.time_s, solution.x);
            solved.push_back({stage, solution});
            return true;
        };
        Kinematics next;
        const StepProblem<decltype(solve)> problem{solver.mass(), t, h, model.velocity_force_1_s, solve};
        if (!take_step(options.integrator, problem, state, next)) {
            trace.status = RunStatus::failed;
            trace.message = where_it_failed(t, h, last.message);
            return trace;
        }
        if (observer.stepped) observer.stepped(solver, t, h, solved);
        state = std::move(next);
        t = ends[k];
        record(t);
        if (jump_at_end) {
            set_force(t);
            past.restart(t, state.x);
        }
        if (!state.v.allFinite()) {
            trace.status = RunStatus::failed;
            trace.message = where_it_failed(t, h, "the motion is no longer finite");
            return trace;
        }
        progress.report({"simulate", t, options.end_s, "s", {}});
    }
    trace.factor_bytes = sizeof(float) * solver.factor_entries();
    trace.status = RunStatus::complete;
    return trace;
}

}  // namespace myo
