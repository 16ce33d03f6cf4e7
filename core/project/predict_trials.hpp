#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.hpp"
#include "project/prediction.hpp"

namespace myo {

/// One trial to be run with these values, which outlive the run.
struct PredictionTask {
    std::size_t trial = 0;
    const StudyValues* values = nullptr;
    std::shared_ptr<const StagePath> near{};   // see predict_trial()
};

/// Runs the tasks side by side on the study's threads; one prediction per task. Progress is the simulated time of all together
/// [s], at most ten times a second. A trial that cannot be run, or that was cancelled, says so in its prediction.
std::vector<TrialPrediction> predict_trials(const Study& study, const std::vector<PredictionTask>& tasks,
                                            const std::vector<StudyParameter>& parameters = {}, const Progress& progress = {});

/// The same of trials with one set of values.
std::vector<TrialPrediction> predict_trials_with(const Study& study, const StudyValues& values, const std::vector<std::size_t>& trials, const Progress& progress = {},
                                                 const std::vector<StudyParameter>& parameters = {});

struct PathPolicy {
    double most_bytes = 1e8;   // of a trial's: 20 thousand degrees of freedom, 300 steps
};
inline constexpr PathPolicy path_policy;

/// The study with the paths of its runs kept, for others to start their stages near to, where they take no more memory
/// than the policy grants.
Study with_kept_paths(Study study);

bool all_ok(const std::vector<TrialPrediction>& predictions);

/// The trials that are fitted, or those that are predicted.
std::vector<std::size_t> trials_with_role(const Study& study, TrialRole role);

}  // namespace myo
