#include <utility>

#include "project/optimize_study.hpp"
#include "project/shorter_steps.hpp"
#include "project/study_target.hpp"
#include "project/time_step.hpp"

namespace myo {
namespace {

Study with_signals(Study study, const SoughtSignals& sought, const Eigen::MatrixXd& values) {
    StudyTrial& trial = study.trials.front();
    trial.recorded_activation = activations_of(sought, values);
    set_step(trial, trial.options.h_s);
    return study;
}

/// The search, and again with shorter steps where its signals ask for them.
Optimization search_with_chosen_steps(Study& study, const ActuationProblem& problem, const OptimizeSettings& settings,
                                      const Eigen::MatrixXd& start, const Progress& progress) {
    Optimization found = search_signals(study, problem, settings, start, progress);
    if (!choosable(study.settings)) return found;
    for (int search = 1; search < shorter_steps_policy.most_fits; ++search) {
        if (!found.fit.converged() || progress.cancelled()) break;
        const Study moved = with_signals(study, problem.sought, found.fit.values);
        std::vector<TrialStep> steps =
            choose_steps(moved, placed_values(moved, found.fit.best.placement), progress);
        const bool shorter = much_shorter(study, steps);
        set_shorter_steps(study, std::move(steps));
        if (!shorter) break;
        ActuationProblem finer = problem;
        finer.options.h_s = study.trials.front().options.h_s;
        OptimizeSettings once = settings;
        once.starts = 1;
        Optimization next = search_signals(study, finer, once, found.fit.values, progress);
        if (!next.usable()) break;   // stopped at once: the signals there are were found with longer steps
        next.earlier_evaluations = found.earlier_evaluations + static_cast<int>(found.fit.log.size());
        next.fit.first = std::move(found.fit.first);
        next.fit.start = found.fit.start;
        next.starts.insert(next.starts.begin(), found.starts.begin(), found.starts.end());
        next.seconds += found.seconds;
        found = std::move(next);
    }
    return found;
}

}  // namespace

Optimization optimize_with_chosen_steps(Study& study, const ActuationProblem& problem, const OptimizeSettings& settings,
                                        const Eigen::MatrixXd& start, const Progress& progress) {
    Optimization found = search_with_chosen_steps(study, problem, settings, start, progress);
    judge_signals(study, found, progress);
    return found;
}

StudyRun run_with_found_signals(const Study& study, const Optimization& found, const Progress& progress) {
    const Study moved = with_signals(study, found.problem.sought, found.fit.values);
    return run_study(moved, placed_values(moved, found.fit.best.placement), progress);
}

}  // namespace myo
