#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.hpp"
#include "prediction/prediction.hpp"

namespace myo::prediction {

/// One trial to simulate with given parameter values; values and setup must outlive the run.
struct PredictionTask {
    std::size_t trial = 0;  // index into Setup::trials
    const ParameterValues* values = nullptr;
    std::shared_ptr<const dynamics::StagePath> warm_start{};  // see predict_trial()
    const setup::Setup* setup = nullptr;                      // its own, such as a finer mesh; null: that of the call
};

/// Simulates the tasks in parallel on the setup's threads.
///
/// @param parameters  for which the residuals are differentiated; may be empty
/// @param progress    simulated time of all tasks together [s], at most ten reports a second
/// @return            one prediction per task, in their order
/// Errors: none. A trial that fails or is cancelled has status and message in its prediction.
std::vector<TrialPrediction> predict_trials(const setup::Setup& setup, const std::vector<PredictionTask>& tasks,
                                            const std::vector<ModelParameter>& parameters = {},
                                            const Progress& progress = {});

/// predict_trials() for several trials with the same parameter values.
std::vector<TrialPrediction> predict_trials_with(const setup::Setup& setup, const ParameterValues& values,
                                                 const std::vector<std::size_t>& trials, const Progress& progress = {},
                                                 const std::vector<ModelParameter>& parameters = {});

/// Memory limit for stored paths.
struct PathPolicy {
    double max_bytes = 1e8;  // per trial: 20 thousand degrees of freedom, 300 steps
};
inline constexpr PathPolicy path_policy;

/// The setup with keep_path set for every trial whose path stays within the memory limit. Runs with similar parameter
/// values can then start their stages from these solutions.
setup::Setup with_kept_paths(setup::Setup setup);

/// Whether all predictions are complete.
bool all_ok(const std::vector<TrialPrediction>& predictions);

/// Indices of the trials with this role, ascending.
std::vector<std::size_t> trials_with_role(const setup::Setup& setup, experiment::TrialRole role);

}  // namespace myo::prediction
