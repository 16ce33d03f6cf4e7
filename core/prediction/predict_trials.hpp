#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.hpp"
#include "prediction/prediction.hpp"

namespace myo::prediction {

/// One trial to be run with these values, which outlive the run.
struct PredictionTask {
    std::size_t trial = 0;
    const ParameterValues* values = nullptr;
    std::shared_ptr<const dynamics::StagePath> near{};  // see predict_trial()
};

/// Runs the tasks side by side on the setup's threads; one prediction per task. Progress is the simulated time of all
/// together [s], at most ten times a second. A trial that cannot be run, or that was cancelled, says so in its
/// prediction.
std::vector<TrialPrediction> predict_trials(const setup::Setup& setup, const std::vector<PredictionTask>& tasks,
                                            const std::vector<ModelParameter>& parameters = {},
                                            const Progress& progress = {});

/// The same of trials with one set of values.
std::vector<TrialPrediction> predict_trials_with(const setup::Setup& setup, const ParameterValues& values,
                                                 const std::vector<std::size_t>& trials, const Progress& progress = {},
                                                 const std::vector<ModelParameter>& parameters = {});

struct PathPolicy {
    double most_bytes = 1e8;  // of a trial's: 20 thousand degrees of freedom, 300 steps
};
inline constexpr PathPolicy path_policy;

/// The setup with the paths of its runs kept, for others to start their stages near to, where they take no more memory
/// than the policy grants.
setup::Setup with_kept_paths(setup::Setup setup);

bool all_ok(const std::vector<TrialPrediction>& predictions);

/// The trials that are fitted, or those that are predicted.
std::vector<std::size_t> trials_with_role(const setup::Setup& setup, experiment::TrialRole role);

}  // namespace myo::prediction
