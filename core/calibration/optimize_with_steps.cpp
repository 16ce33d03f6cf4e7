#include <utility>

#include "calibration/body_design.hpp"
#include "calibration/optimize.hpp"
#include "calibration/sought_signals.hpp"
#include "prediction/shorter_steps.hpp"
#include "prediction/time_step.hpp"
#include "prediction/trial_goals.hpp"
#include "prediction/trial_target.hpp"

namespace myo::calibration {
namespace {

/// The setup with what a search found. Signals replace the recorded activation, so that set_step() treats their jumps.
setup::Setup with_found(setup::Setup setup, const inverse::ActuationProblem& problem,
                        const inverse::ActuationFit& fit) {
    setup = with_design(std::move(setup), problem.design, fit.design);
    if (problem.sought.signals.empty()) return setup;
    setup::PreparedTrial& trial = setup.trials.front();
    const std::vector<fibre::Signal> commands = found_commands(problem.sought, fit.values);
    // Muscles come first, then chambers and tendons, see actuator_signals.hpp.
    const auto first_command = commands.begin() + static_cast<std::ptrdiff_t>(trial.recorded_activation.size());
    trial.recorded_activation.assign(commands.begin(), first_command);
    trial.recorded_commands.assign(first_command, commands.end());
    setup::set_step(trial, trial.options.h_s);
    return setup;
}

/// Search, repeated with shorter steps as long as its signals require them.
Optimization search_with_chosen_steps(setup::Setup& setup, const inverse::ActuationProblem& problem,
                                      const OptimizeSettings& settings, const inverse::ActuationStart& start,
                                      const Progress& progress) {
    Optimization found = search_signals(setup, problem, settings, start, progress);
    if (!prediction::choosable(setup.settings) || setup.trials.front().hold) return found;
    for (int search = 1; search < prediction::shorter_steps_policy.max_fits; ++search) {
        if (!found.fit.converged() || progress.cancelled()) break;
        // The evaluations end with the last goal, and so do the runs from which steps are chosen.
        const setup::Setup moved = prediction::until_last_goal(with_found(setup, problem, found.fit));
        std::vector<setup::TrialStep> steps = prediction::choose_steps(
            moved, prediction::placed_values(moved, found.fit.best.placement), progress);
        const bool shorter = prediction::much_shorter(setup, steps);
        prediction::set_shorter_steps(setup, std::move(steps));
        if (!shorter) break;
        inverse::ActuationProblem finer = problem;
        finer.options.h_s = setup.trials.front().options.h_s;
        OptimizeSettings once = settings;
        once.starts = 1;
        Optimization next = search_signals(setup, finer, once, {found.fit.values, found.fit.design}, progress);
        if (!next.usable()) break;  // cancelled at once: keep the signals found with longer steps
        // The result is one search: it begins where the first one began, and the starts of all are its own.
        next.settings = found.settings;
        next.fit.first = std::move(found.fit.first);
        next.fit.start = found.fit.start;
        next.starts.insert(next.starts.begin(), found.starts.begin(), found.starts.end());
        next.seconds += found.seconds;
        found = std::move(next);
    }
    return found;
}

}  // namespace

Optimization optimize_with_chosen_steps(setup::Setup& setup, const inverse::ActuationProblem& problem,
                                        const OptimizeSettings& settings, const inverse::ActuationStart& start,
                                        const Progress& progress) {
    Optimization found = search_with_chosen_steps(setup, problem, settings, start, progress);
    judge_signals(setup, found, progress);
    return found;
}

prediction::SetupRun run_with_found_signals(const setup::Setup& setup, const Optimization& found,
                                            const Progress& progress) {
    const setup::Setup moved = with_found(setup, found.problem, found.fit);
    return prediction::run_trials(moved, prediction::placed_values(moved, found.fit.best.placement), progress);
}

}  // namespace myo::calibration
