#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "prediction/prediction.hpp"
#include "setup/setup.hpp"

namespace myo::prediction {

/// Comparison of one marker in a trial. Steady state: mean over the last fifth of the samples.
struct MarkerScore {
    std::string name;
    double rms_m = 0.0;                  // over its compared coordinates
    Eigen::Vector3d steady_simulated_m;  // position, or displacement from rest, as compared; NaN if never visible
    Eigen::Vector3d steady_measured_m;
    double steady_error_m = 0.0;  // norm of their difference
    double distance_m = 0.0;      // mean distance of prediction and measurement over its samples
};

/// Comparison of one column of a sensor in a trial.
struct SensorScore {
    std::string column, unit;
    double noise = 0.0;  // 1 sigma, in the unit
    double rms = 0.0;    // over its compared readings, in the unit; NaN if none lies within the run
};

/// Comparison of one trial, over all markers and per marker.
struct TrialScore {
    std::string name;
    experiment::TrialRole role = experiment::TrialRole::fit;
    double rms_m = 0.0;  // over all compared coordinates
    std::vector<MarkerScore> markers;
    double distance_m = 0.0;  // mean of the markers' distances
    std::vector<SensorScore> sensors{};
};
/// Scores a complete prediction against the recording.
///
/// @param trial  index into Setup::trials
TrialScore score(const setup::Setup& setup, std::size_t trial, const TrialPrediction& prediction);

/// All trials simulated with the same parameter values.
struct SetupRun {
    ParameterValues values;
    std::vector<TrialPrediction> predictions;  // one per trial of the setup
    std::vector<TrialScore> scores;            // of the completed trials
    double fit_rms_m = 0.0;                    // over the fit trials; NaN if there are none or one failed
    double validation_rms_m = 0.0;             // over the validation trials, likewise
    double seconds = 0.0;                      // wall-clock time
    std::string failure;                       // reason for the first failed trial; empty if all completed

    bool ok() const { return failure.empty(); }
};

/// Scores predictions that were made before.
///
/// @param predictions  one per trial of the setup
/// @param trials       indices of those that were requested
SetupRun scored_run(const setup::Setup& setup, const ParameterValues& values, std::vector<TrialPrediction> predictions,
                    const std::vector<std::size_t>& trials);

/// Simulates and scores the trials on the setup's threads.
///
/// @param only_trial  name of a single trial; empty: all. Others have status not_run
/// Errors: none; see SetupRun::failure.
SetupRun run_trials(const setup::Setup& setup, const ParameterValues& values, const Progress& progress = {},
                    const std::string& only_trial = {});

/// Sets the free levels of validation trials from those of the fit trials: interpolated over a shared test condition,
/// see curve_through(); without a shared condition, the mean of their levels.
ParameterValues with_predicted_levels(const setup::Setup& setup, ParameterValues values);

}  // namespace myo::prediction
