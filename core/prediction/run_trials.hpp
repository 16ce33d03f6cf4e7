#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "prediction/prediction.hpp"
#include "setup/setup.hpp"

namespace myo::prediction {

/// How one marker of a trial compares. Steady state: the mean over the last fifth of the samples.
struct MarkerScore {
    std::string name;
    double rms_m = 0.0;                  // over its compared coordinates
    Eigen::Vector3d steady_simulated_m;  // position, or displacement from rest, as compared
    Eigen::Vector3d steady_measured_m;
    double steady_error_m = 0.0;  // length of their difference
};

struct TrialScore {
    std::string name;
    experiment::TrialRole role = experiment::TrialRole::fit;
    double rms_m = 0.0;
    std::vector<MarkerScore> markers;
};
TrialScore score(const setup::Setup& setup, std::size_t trial, const TrialPrediction& prediction);

/// All trials run once with the same values.
struct SetupRun {
    ParameterValues values;
    std::vector<TrialPrediction> predictions;  // per trial
    std::vector<TrialScore> scores;            // of the trials that completed
    double fit_rms_m = 0.0;                    // over the fit trials; NaN when there are none or one did not complete
    double validation_rms_m = 0.0;             // over the validation trials, likewise
    double seconds = 0.0;
    std::string failure;  // why the first trial that did not complete did not; empty when all did

    bool ok() const { return failure.empty(); }
};

/// A run from predictions already made, one per trial of the setup; `trials`: those that were asked for.
SetupRun scored_run(const setup::Setup& setup, const ParameterValues& values, std::vector<TrialPrediction> predictions,
                    const std::vector<std::size_t>& trials);

/// Runs the trials (all, or the named one) on the setup's threads. Trials that were not asked for have status not_run.
SetupRun run_trials(const setup::Setup& setup, const ParameterValues& values, const Progress& progress = {},
                    const std::string& only_trial = {});

/// Levels of validation trials, from the condition by a curve through the fit trials' levels.
/// Where the conditions do not tell (none shared, or a single value), the mean of the levels.
ParameterValues with_predicted_levels(const setup::Setup& setup, ParameterValues values);

}  // namespace myo::prediction
