#include "dynamics/live_run.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "dynamics/energy_gain.hpp"
#include "dynamics/softening.hpp"
#include "dynamics/start_state.hpp"
#include "model/point_pull.hpp"

namespace myo::dynamics {
namespace {

struct LiveRunPolicy {
    double max_parts = 4.0;    // a failing step is halved down to this fraction, as in simulate()
    double jump_share = 1e-6;  // of a step: a jump nearer than this is passed with the step before
};
constexpr LiveRunPolicy live_run_policy;

bool same_grip(const std::optional<Grip>& a, const std::optional<Grip>& b) {
    if (!a || !b) return !a && !b;
    return a->nodes == b->nodes && a->shares == b->shares && a->places_m == b->places_m &&
           a->stiffness_N_m == b->stiffness_N_m;
}

/// The model with constant signals.
void set_signals(const LiveControls& controls, model::Model& model) {
    for (std::size_t g = 0; g < std::min(model.activation.size(), controls.activation.size()); ++g)
        model.activation[g] = fibre::Signal::constant(controls.activation[g]);
    std::size_t k = 0;
    for (model::ForceElementPointer& element : model.force_elements)
        if (element->command() && k < controls.commands.size())
            element = element->with_command(fibre::Signal::constant(controls.commands[k++]));
}

}  // namespace

LiveControls controls_of(const model::Model& model, double time_s) {
    LiveControls controls;
    controls.damping_s = model.damping_s;
    controls.velocity_force_1_s = model.velocity_force_1_s;
    controls.activation = model::activations(model, time_s);
    for (const model::ForceElementPointer& element : model.force_elements)
        if (const fibre::Signal* command = element->command()) controls.commands.push_back(command->value(time_s));
    return controls;
}

LiveRun::LiveRun(model::Model model, const SimulationOptions& options)
    : model_(std::move(model)), options_(options), own_elements_(model_.force_elements.size()) {}

Result<std::unique_ptr<LiveRun>> LiveRun::begin(model::Model model, const SimulationOptions& options,
                                                const LiveControls& controls, const Progress& progress) {
    std::unique_ptr<LiveRun> run(new LiveRun(std::move(model), options));
    // The start state is that of the model's own signals; the controls act from t = 0 on.
    run->renew_solver();
    run->solver_->stop_with(progress);
    Trace trace;
    if (!set_start(options, *run->solver_, run->point_.state, trace))
        return Error{progress.cancelled() ? "stopped at the start" : trace.message, ""};
    if (run->model_.softening) raise_peaks(run->model_, run->point_.state.x, run->point_.peak_energy_J_m3);
    run->controls_ = controls;
    set_signals(controls, run->model_);
    run->jumps_ = model::jump_times(run->model_);
    run->apply(controls);
    run->renew_solver();
    set_jump_force(*run->solver_, 0.0, run->point_.state);
    run->euler_next_ = needs_euler(run->model_, controls.h_s, run->point_.state);
    run->stepper_->restart(0.0, run->point_.state.x);
    return run;
}

void LiveRun::renew_solver() {
    stepper_.reset();
    solver_ = std::make_unique<StageSolver>(model_, options_.solver);
    if (model_.softening && point_.peak_energy_J_m3.size() > 0)
        solver_->soften(softening_factors(*model_.softening, point_.peak_energy_J_m3));
    stepper_ = std::make_unique<Stepper>(*solver_, nullptr, controls_.h_s, false);
}

void LiveRun::apply(const LiveControls& controls) {
    model_.damping_s = controls.damping_s;
    model_.velocity_force_1_s = controls.velocity_force_1_s;
    model_.force_elements.resize(own_elements_);
    set_signals(controls, model_);
    if (controls.grip)
        model_.force_elements.push_back(model::point_pull(*model_.body, controls.grip->nodes, controls.grip->shares,
                                                          controls.grip->places_m, controls.grip->stiffness_N_m));
    controls_ = controls;
}

Result<void> LiveRun::advance(const LiveControls& controls, const Progress& progress) {
    const bool loads_change = controls.activation != controls_.activation || controls.commands != controls_.commands ||
                              controls.velocity_force_1_s != controls_.velocity_force_1_s ||
                              controls.grip.has_value() != controls_.grip.has_value();
    const bool damping_changes = controls.damping_s != controls_.damping_s;
    const bool changes = loads_change || damping_changes || !same_grip(controls.grip, controls_.grip);
    if (changes)
        apply(controls);
    else
        controls_.h_s = controls.h_s;
    // The viscous moduli belong to the constants of the solver.
    if (damping_changes) renew_solver();
    solver_->stop_with(progress);
    if (changes) set_jump_force(*solver_, point_.time_s, point_.state);
    if (loads_change || damping_changes) stepper_->restart(point_.time_s, point_.state.x);
    double end = point_.time_s + controls.h_s;
    const auto next = std::upper_bound(jumps_.begin(), jumps_.end(),
                                       point_.time_s + live_run_policy.jump_share * controls.h_s);
    const bool jumps = next != jumps_.end() && *next <= end * (1.0 + live_run_policy.jump_share);
    if (jumps) end = *next;
    return step_to(end, jumps, progress);
}

Result<void> LiveRun::step_to(double end_s, bool jump_at_end, const Progress& progress) {
    Trace counts;
    std::optional<RunPoint> before;  // once a part of the step is taken
    const double least = (end_s - point_.time_s) / live_run_policy.max_parts;
    for (double goal = end_s; point_.time_s < end_s;) {
        const double h = goal - point_.time_s;
        const TimeScheme scheme = euler_next_ ? TimeScheme(Integrator::implicit_euler) : options_.integrator;
        SolvedStep step = stepper_->solve(scheme, point_.time_s, point_.state, goal, jump_at_end && goal == end_s,
                                          counts);
        const bool can_halve = h > 1.5 * least;
        if (can_halve &&
            (!step.taken || (!step.resolved && gains_energy(*solver_, point_.state, step.next, point_.time_s, goal)))) {
            goal = point_.time_s + 0.5 * h;
            stepper_->restart(point_.time_s, point_.state.x);
        } else if (step.taken) {
            if (!before && goal != end_s) before = point_;
            accept(step);
            goal = end_s;
        } else {
            if (before) point_ = std::move(*before);
            stepper_->restart(point_.time_s, point_.state.x);
            if (progress.cancelled()) return Error{"stopped", ""};
            return Error{step.last.ok() ? "the motion is no longer finite" : step.last.message, ""};
        }
    }
    return {};
}

void LiveRun::accept(SolvedStep& step) {
    const bool was_euler = std::exchange(euler_next_, false);
    point_.state = std::move(step.next);
    point_.time_s = step.end_s;
    if (model_.softening) {
        raise_peaks(model_, point_.state.x, point_.peak_energy_J_m3);
        solver_->soften(softening_factors(*model_.softening, point_.peak_energy_J_m3));
    }
    if (step.jump_at_end) set_jump_force(*solver_, point_.time_s, point_.state);
    if (step.jump_at_end || was_euler) stepper_->restart(point_.time_s, point_.state.x);
}

Eigen::Vector3d LiveRun::grip_force() const {
    if (!controls_.grip) return Eigen::Vector3d::Zero();
    const Grip& grip = *controls_.grip;
    return grip.stiffness_N_m * (grip.places_m - point_.state.x(Eigen::all, grip.nodes)) * grip.shares;
}

}  // namespace myo::dynamics
