#include "dynamics/simulate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "dynamics/energy.hpp"
#include "dynamics/extrapolation.hpp"
#include "dynamics/statics.hpp"
#include "dynamics/undeformed.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;

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

void hold_clamped(const Body& body, Matrix3Xd& x) {
    for (int i = 0; i < body.node_count(); ++i)
        if (body.clamped[static_cast<std::size_t>(i)]) x.col(i) = body.mesh.nodes.col(i);
}

/// Whether these velocities turn or strain a cell by more than half of itself within h.
bool tears(const Body& body, const Matrix3Xd& v, double h) {
    const Matrix3Xd& X = body.mesh.nodes;
    for (const auto& cell : body.mesh.cells.colwise())
        for (const int a : cell)
            for (const int b : cell)
                if (h * (v.col(a) - v.col(b)).norm() > 0.5 * (X.col(a) - X.col(b)).norm()) return true;
    return false;
}

/// Steps are halved until they are this part of what they were.
constexpr double most_parts = 4.0;

/// Whether a step has more energy at its end than loads, muscles and velocity force account for: by a fiftieth of what moves.
bool gains_energy(const Model& model, const Eigen::SparseMatrix<double>& mass, const Kinematics& from, const Kinematics& to, double from_s, double to_s) {
    if (model.velocity_force_1_s > 0.0 || activations(model, 0.5 * (from_s + to_s)) != activations(model, to_s, true)) return false;
    const Energy before = energy(model, mass, from.x, from.v, to_s, true), after = energy(model, mass, to.x, to.v, to_s, true);
    const double moved = before.kinetic_J + after.kinetic_J + std::abs(after.internal_J - before.internal_J);
    return after.total_J() - before.total_J() > 0.02 * moved;   // false where there was none before
}

/// Positions and velocities at t = 0. False: there are none, and the trace says why.
bool set_start(const SimulationOptions& options, StageSolver& solver, Kinematics& state, Trace& trace) {
    const Body& body = *solver.model().body;
    const InitialState& initial = options.initial;
    assert(initial.positions.size() == 0 || initial.positions.cols() == body.node_count());
    assert(initial.velocities.size() == 0 || initial.velocities.cols() == body.node_count());
    state.x = initial.positions.size() > 0 ? initial.positions : body.mesh.nodes;
    state.v = initial.velocities.size() > 0 ? initial.velocities : Matrix3Xd::Zero(3, body.node_count());
    hold_clamped(body, state.x);
    for (int i = 0; i < body.node_count(); ++i)
        if (body.clamped[static_cast<std::size_t>(i)]) state.v.col(i).setZero();
    trace.status = RunStatus::failed;
    if (!state.x.allFinite() || !state.v.allFinite()) {
        trace.message = "the initial positions or velocities are not finite";
        return false;
    }
    if (!options.starts_at_equilibrium()) return true;
    const StageReport report = solve_equilibrium(solver, 0.0, state.x);
    count(report, trace);
    trace.message = report.message;
    return report.ok();
}

}  // namespace

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

Stage jump_stage(const Kinematics& state, double time_s) {
    Stage stage;
    stage.time_s = time_s;
    stage.constant = Eigen::Matrix3Xd::Zero(3, state.x.cols());
    stage.rate_history = state.rate;
    return stage;
}

void set_jump_force(StageSolver& solver, double time_s, Kinematics& state) {
    state.force = solver.total_forces(jump_stage(state, time_s), state.x) + solver.model().velocity_force_1_s * times_mass(state.v, solver.mass());
}

Trace simulate(const Model& model, const SimulationOptions& options, const Progress& progress, const RunObserver& observer) {
    StageSolver solver(model, options.solver);
    return simulate_part(solver, options, {}, progress, observer);
}

Trace simulate_part(StageSolver& solver, const SimulationOptions& options, const RunPart& part, const Progress& progress, const RunObserver& observer) {
    const Model& model = solver.model();
    const Body& body = *model.body;
    Trace trace;
    RunPoint point;
    Kinematics& state = point.state;
    if (part.from) {
        point = *part.from;
    } else {
        if (!set_start(options, solver, state, trace)) return trace;
        state.strain = strains(body, state.x);
        state.rate = strain_tangent(body, state.x, state.v);
        if (observer.started) observer.started(solver, state);
    }

    const auto record = [&](double t) {
        trace.times_s.push_back(t);
        if (!part.keep_motion) return;
        trace.positions.push_back(state.x);
        trace.velocities.push_back(state.v);
    };
    const auto set_force = [&](double t) {
        set_jump_force(solver, t, state);
        if (observer.jumped) observer.jumped(solver, state, t);
    };
    record(point.time_s);
    const std::vector<double> ends = step_ends(model, options.h_s, options.end_s);
    const std::vector<double> jumps = jump_times(model);
    // A jump within rounding of the start belongs to the start.
    double loads_from = 0.0;
    for (const double jump : jumps)
        if (jump > 0.0 && jump <= 1e-6 * options.h_s) loads_from = jump;
    if (!part.from) set_force(loads_from);
    // Neither force nor strain of a start without energy is worth remembering.
    const bool lost = !state.force.allFinite() || !state.strain.allFinite();
    if (lost) {
        state.force.setZero();
        state.strain = strains(body, body.mesh.nodes);
        state.rate.setZero();
    }
    // The trapezoid would take the mean of viscous forces that turn while it does: it feeds in many times the energy of the motion.
    const bool by_euler = lost || (model.damping_s > 0.0 && !ends.empty() && tears(body, state.v, ends.front()));
    Extrapolation past;
    past.restart(point.time_s, state.x);
    if (observer.stood) observer.stood(point);
    double& t = point.time_s;
    while (point.step < std::min(ends.size(), part.until_step)) {
        const double end = ends[point.step];
        std::vector<double> goals{end};   // the next one last: a step that fails is halved
        for (double least = (end - t) / most_parts; !goals.empty();) {
            if (progress.cancelled()) {
                trace.status = RunStatus::cancelled;
                trace.message = "stopped at t = " + std::to_string(t) + " s";
                return trace;
            }
            const double goal = goals.back(), h = goal - t;
            const bool jump_at_end = goal == end && is_jump(jumps, end, options.h_s);
            bool resolved = true;
            std::vector<SolvedStage> solved;
            StageReport last;
            const auto solve = [&](Stage& stage, StageSolution& solution) {
                if (std::abs(stage.time_s - goal) < 1e-9 * h) stage.time_s = goal;
                stage.before_jump = jump_at_end && stage.time_s == goal;
                const auto without_past = [&]() -> Matrix3Xd {
                    return solved.empty() ? Matrix3Xd(state.x + (stage.time_s - t) * state.v) : solved.back().solution.x;
                };
                const std::optional<Matrix3Xd> continued = past.at(stage.time_s);
                // A guess that leads nowhere may have turned cells inside out: then from where the body was, and from no strain at all.
                last = {};
                for (int attempt = 0; attempt < 3 && !last.ok(); ++attempt) {
                    solution.x = attempt == 1 ? state.x : attempt == 2 ? undeformed_near(body, state.x) : continued ? *continued : without_past();
                    hold_clamped(body, solution.x);
                    last = solver.solve(stage, solution.x);
                    count(last, trace);
                    // Forces are measured against those at the guess, and one that is far off makes little of what is left of them.
                    if (attempt < 2 || !last.ok()) continue;
                    last = solver.solve(stage, solution.x);
                    count(last, trace);
                }
                if (!last.ok()) return false;
                resolved = resolved && continued && (solution.x - *continued).norm() < 0.1 * (solution.x - state.x).norm();
                solution.strain = strains(body, solution.x);
                past.add(stage.time_s, solution.x);
                solved.push_back({stage, solution});
                return true;
            };
            Kinematics next;
            const StepProblem<decltype(solve)> problem{solver.mass(), t, h, model.velocity_force_1_s, solve};
            const TimeScheme scheme = by_euler && t == 0.0 ? TimeScheme(Integrator::implicit_euler) : options.integrator;
            const bool taken = take_step(scheme, problem, state, next) && next.v.allFinite();
            if (h > 1.5 * least && (!taken || (!resolved && gains_energy(model, solver.mass(), state, next, t, goal)))) {
                goals.push_back(t + 0.5 * h);
                past.restart(t, state.x);
                continue;
            }
            if (!taken) {
                trace.status = RunStatus::failed;
                trace.message = where_it_failed(t, h, last.ok() ? "the motion is no longer finite" : last.message);
                return trace;
            }
            if (observer.stepped) observer.stepped(solver, scheme, t, h, solved);
            const bool restart = jump_at_end || (by_euler && t == 0.0);
            state = std::move(next);
            t = goal;
            goals.pop_back();
            record(t);
            if (jump_at_end) set_force(t);
            if (restart) past.restart(t, state.x);
            if (goals.empty()) ++point.step;
            if (observer.stood) observer.stood(point);
            progress.report({"simulate", t, options.end_s, "s", {}});
        }
    }
    trace.factor_bytes = sizeof(float) * solver.factor_entries();
    trace.status = RunStatus::complete;
    return trace;
}

}  // namespace myo
