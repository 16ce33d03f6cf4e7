#include "dynamics/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "dynamics/energy_gain.hpp"
#include "dynamics/run_advice.hpp"
#include "dynamics/softening.hpp"
#include "dynamics/start_state.hpp"
#include "dynamics/step_grid.hpp"
#include "dynamics/stepper.hpp"

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

/// State of a run in progress.
class Run {
public:
    Run(StageSolver& solver, const SimulationOptions& options, const RunPart& part, const RunObserver& observer)
        : solver_(solver),
          options_(options),
          part_(part),
          observer_(observer),
          stepper_(solver, options.warm_start, options.h_s, static_cast<bool>(observer.stepped)),
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
                SolvedStep step = take_step_to(goals.back(), goals.back() == end && is_jump(jumps_, end, options_.h_s));
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

    void restart_prediction() { stepper_.restart(point_.time_s, point_.state.x); }

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

    SolvedStep take_step_to(double end_s, bool jump_at_end) {
        const TimeScheme scheme = euler_first_ ? TimeScheme(Integrator::implicit_euler) : options_.integrator;
        return stepper_.solve(scheme, point_.time_s, point_.state, end_s, jump_at_end, trace_);
    }

    /// Makes the end of a step the current state. `grid`: the end is one of step_ends().
    void advance_to(SolvedStep& step, bool grid) {
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
    Stepper stepper_;
    std::vector<double> jumps_;
    Trace trace_;
    RunPoint point_;
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
