#include "dynamics/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "dynamics/creep.hpp"
#include "dynamics/energy.hpp"
#include "dynamics/extrapolation.hpp"
#include "dynamics/run_advice.hpp"
#include "dynamics/softening.hpp"
#include "dynamics/start_state.hpp"
#include "dynamics/step_grid.hpp"
#include "dynamics/undeformed.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;

/// @param commands  of the force elements then, in words; empty: none
std::string where_it_failed(double t, double h, const std::string& commands, const std::string& reason) {
    return "at t = " + std::to_string(t) + " s (h = " + std::to_string(h) + " s" +
           (commands.empty() ? "" : ", " + commands) + ") " + reason + "; " + smaller_step_advice;
}

struct SimulatePolicy {
    /// A failing step is halved down to this fraction of its length.
    double max_parts = 4.0;
};
constexpr SimulatePolicy simulate_policy;

/// Whether the energy gained in a step exceeds what loads, muscles and velocity force supply by more than 2 % of the
/// energy that is in motion. Only checked if these are constant over the step. Softening dissipates between steps;
/// therefore the stiffness of this step is used at both ends.
bool gains_energy(const StageSolver& solver, const Kinematics& from, const Kinematics& to, double from_s, double to_s) {
    const model::Model& model = solver.model();
    if (model.velocity_force_1_s > 0.0 ||
        model::activations(model, 0.5 * (from_s + to_s)) != model::activations(model, to_s, true))
        return false;
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

/// State of a run in progress.
class Run {
public:
    Run(StageSolver& solver, const SimulationOptions& options, const RunPart& part, const RunObserver& observer)
        : solver_(solver),
          options_(options),
          part_(part),
          observer_(observer),
          jumps_(model::jump_times(solver.model())) {
        if (options.keep_path) trace_.path = std::make_shared<StagePath>();
    }

    Trace take(const Progress& progress) {
        const std::vector<double> ends = step_ends(model(), options_.h_s, options_.end_s);
        solver_.stop_with(progress);
        if (!set_first_point(ends))
            return progress.cancelled() ? ended(RunStatus::cancelled, "stopped at the start") : std::move(trace_);
        while (point_.step < std::min(ends.size(), part_.until_step)) {
            const double end = ends[point_.step];
            std::vector<double> goals{end};  // stack of targets, the next one last; halving a step pushes its midpoint
            for (const double least = (end - point_.time_s) / simulate_policy.max_parts; !goals.empty();) {
                if (progress.cancelled())
                    return ended(RunStatus::cancelled, "stopped at t = " + std::to_string(point_.time_s) + " s");
                if (trace_.newton_iterations > options_.max_iterations)
                    return ended(RunStatus::failed, "at t = " + std::to_string(point_.time_s) +
                                                        " s the run has taken more than " +
                                                        std::to_string(options_.max_iterations) + " iterations");
                Step step = take_step_to(goals.back(), goals.back() == end && is_jump(jumps_, end, options_.h_s));
                const double h = goals.back() - point_.time_s;
                if (h > 1.5 * least && (!step.taken || (!step.resolved && gains_energy(solver_, point_.state, step.next,
                                                                                       point_.time_s, goals.back())))) {
                    goals.push_back(point_.time_s + 0.5 * h);
                    restart_prediction();
                    continue;
                }
                if (!step.taken)
                    return ended(
                        RunStatus::failed,
                        where_it_failed(point_.time_s, h, model::command_words(model(), goals.back(), true),
                                        step.last.ok() ? "the motion is no longer finite" : step.last.message));
                goals.pop_back();
                advance_to(step, goals.empty());
                progress.report({"simulate", point_.time_s, options_.end_s, "s", {}});
            }
        }
        trace_.factor_bytes = sizeof(float) * solver_.factor_entries();
        return ended(RunStatus::complete, {});
    }

private:
    /// A step as it was solved.
    struct Step {
        TimeScheme scheme;
        double end_s = 0.0;
        bool jump_at_end = false;
        std::vector<SolvedStage> solved;
        StageReport last;
        bool resolved = true;  // all stage solutions were close to the extrapolated motion
        bool taken = false;
        Kinematics next;
    };

    const model::Model& model() const { return solver_.model(); }

    Trace ended(RunStatus status, const std::string& message) {
        trace_.status = status;
        trace_.message = message;
        return std::move(trace_);
    }

    void record() {
        trace_.times_s.push_back(point_.time_s);
        if (!part_.keep_motion) return;
        trace_.positions.push_back(point_.state.x);
        trace_.velocities.push_back(point_.state.v);
    }

    void keep_path(double time_s, const Matrix3Xd& x) {
        if (!trace_.path) return;
        trace_.path->times_s.push_back(time_s);
        trace_.path->positions.push_back(x);
    }

    /// Discards the prediction history: the past motion does not continue smoothly.
    void restart_prediction() {
        past_.restart(point_.time_s, point_.state.x);
        difference_.clear();
        if (const Matrix3Xd* similar = similar_at(point_.time_s))
            difference_.add(point_.time_s, point_.state.x - *similar);
    }

    /// Stage solution of the similar run at this time; null if there is none.
    const Matrix3Xd* similar_at(double time_s) const {
        return options_.warm_start ? options_.warm_start->at(time_s, options_.h_s) : nullptr;
    }

    /// Recomputes the force at a jump and informs the observer.
    void set_force(double time_s) {
        set_jump_force(solver_, time_s, point_.state);
        if (observer_.jumped) observer_.jumped(solver_, point_.state, time_s);
    }

    /// Sets the start state, or the state of the run point that the part continues from.
    bool set_first_point(const std::vector<double>& ends) {
        if (part_.from) {
            point_ = *part_.from;
        } else {
            if (!set_start(options_, solver_, point_.state, trace_)) return false;
            if (model().softening) raise_peaks(model(), point_.state.x, point_.peak_energy_J_m3);
        }
        if (model().softening) solver_.soften(softening_factors(*model().softening, point_.peak_energy_J_m3));
        if (!part_.from) {
            if (observer_.started) observer_.started(solver_, point_.state);
        }
        record();
        if (!part_.from) {
            // A jump within rounding of the start belongs to the start: loads are taken from its right.
            double loads_from = 0.0;
            for (const double jump : jumps_)
                if (jump > 0.0 && jump <= 1e-6 * options_.h_s) loads_from = jump;
            set_force(loads_from);
            euler_first_ = !ends.empty() && needs_euler(model(), ends.front(), point_.state);
        }
        keep_path(point_.time_s, point_.state.x);
        restart_prediction();
        if (observer_.reached) observer_.reached(point_);
        return true;
    }

    /// Solves a step without changing the run's state, so that it can be rejected.
    Step take_step_to(double end_s, bool jump_at_end) {
        Step step;
        step.scheme = euler_first_ ? TimeScheme(Integrator::implicit_euler) : options_.integrator;
        step.end_s = end_s;
        step.jump_at_end = jump_at_end;
        const double h = end_s - point_.time_s;
        const auto solve = [&](Stage& stage, StageSolution& solution) {
            // Exact comparison with the end is needed below; stage times carry rounding.
            if (std::abs(stage.time_s - end_s) < 1e-9 * h) stage.time_s = end_s;
            stage.before_jump = jump_at_end && stage.time_s == end_s;
            return solve_stage(stage, step, solution);
        };
        const StepProblem<decltype(solve)> problem{solver_.mass(point_.time_s + 0.5 * h), point_.time_s, h,
                                                   model().velocity_force_1_s, solve};
        step.taken = take_step(step.scheme, problem, point_.state, step.next) && step.next.v.allFinite();
        return step;
    }

    /// Solves one stage, with up to three initial guesses, and stores the solution in `step`.
    bool solve_stage(const Stage& stage, Step& step, StageSolution& solution) {
        const model::Body& body = *model().body;
        const std::optional<Matrix3Xd> continued = past_.at(stage.time_s);
        const Matrix3Xd* similar = similar_at(stage.time_s);
        // Initial guess by attempt: 0 prediction (similar run, extrapolation, or constant velocity), 1 last position,
        // 2 undeformed body.
        const auto guess = [&](int attempt) -> Matrix3Xd {
            if (attempt == 1) return point_.state.x;
            if (attempt == 2) return undeformed_near(body, point_.state.x);
            if (similar && difference_.known()) return *similar + difference_.parabola_at(stage.time_s);
            if (continued) return *continued;
            return step.solved.empty() ? Matrix3Xd(point_.state.x + (stage.time_s - point_.time_s) * point_.state.v)
                                       : step.solved.back().solution.x;
        };
        const auto solve = [&]() {
            step.last = solver_.solve(stage, solution.x);
            count(step.last, trace_);
            return step.last.ok();
        };
        // A poor prediction may contain inverted cells; the fallbacks are the last position and the undeformed body.
        // The force scale is taken at the guess: for a distant guess it is large and the relative residual is lenient,
        // so the last attempt is solved twice.
        bool found = false;
        for (int attempt = 0; attempt < 3 && !found; ++attempt) {
            solution.x = held_by(body, guess(attempt));
            found = solve() && (attempt < 2 || solve());
        }
        if (!found) return false;
        // Resolved: the prediction error is less than 10 % of the displacement since the start of the step.
        step.resolved = step.resolved && continued &&
                        (solution.x - *continued).norm() < 0.1 * (solution.x - point_.state.x).norm();
        solution.strain = model::strains(model(), solution.x);
        if (model().creep)
            solution.strain = with_dashpots(*model().creep, stage.rate_factor_1_s, solution.strain, stage.rate_history);
        past_.add(stage.time_s, solution.x);
        if (similar)
            difference_.add(stage.time_s, solution.x - *similar);
        else
            difference_.clear();
        SolvedStage& solved = step.solved.emplace_back();
        if (observer_.stepped) {
            solved = {stage, solution};
        } else {  // the run needs only time and position; strains and histories of all points are large
            solved.stage.time_s = stage.time_s;
            solved.solution.x = solution.x;
        }
        return true;
    }

    /// Makes the end of a step the current state. `grid`: the end is one of step_ends().
    void advance_to(Step& step, bool grid) {
        if (observer_.stepped)
            observer_.stepped(solver_, step.scheme, point_.time_s, step.end_s - point_.time_s, step.solved);
        for (const SolvedStage& solved : step.solved) keep_path(solved.stage.time_s, solved.solution.x);
        const bool was_euler = std::exchange(euler_first_, false);
        point_.state = std::move(step.next);
        point_.time_s = step.end_s;
        // Softening is explicit: the peaks of this step soften the next one.
        if (model().softening) {
            raise_peaks(model(), point_.state.x, point_.peak_energy_J_m3);
            solver_.soften(softening_factors(*model().softening, point_.peak_energy_J_m3));
        }
        record();
        if (step.jump_at_end) set_force(point_.time_s);
        if (step.jump_at_end || was_euler) restart_prediction();
        if (grid) ++point_.step;
        if (observer_.reached) observer_.reached(point_);
    }

    StageSolver& solver_;
    const SimulationOptions& options_;
    const RunPart& part_;
    const RunObserver& observer_;
    std::vector<double> jumps_;
    Trace trace_;
    RunPoint point_;
    Extrapolation past_;
    Extrapolation difference_;  // history of the difference to the similar run `warm_start`
    bool euler_first_ = false;
};

}  // namespace

Stage jump_stage(const Kinematics& state, double time_s) {
    Stage stage;
    stage.time_s = time_s;
    stage.constant = Eigen::Matrix3Xd::Zero(3, state.x.cols());
    stage.rate_history = state.rate;
    stage.velocity_history = state.v;
    return stage;
}

void set_jump_force(StageSolver& solver, double time_s, Kinematics& state) {
    state.force = solver.total_forces(jump_stage(state, time_s), state.x) +
                  solver.model().velocity_force_1_s * model::times_mass(state.v, solver.mass(time_s));
}

Trace simulate(const model::Model& model, const SimulationOptions& options, const Progress& progress,
               const RunObserver& observer) {
    StageSolver solver(model, options.solver);
    return simulate_part(solver, options, {}, progress, observer);
}

Trace simulate_part(StageSolver& solver, const SimulationOptions& options, const RunPart& part,
                    const Progress& progress, const RunObserver& observer) {
    return Run(solver, options, part, observer).take(progress);
}

}  // namespace myo::dynamics
