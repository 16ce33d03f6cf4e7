#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "inverse/least_squares.hpp"
#include "project/prediction.hpp"
#include "project/study.hpp"

namespace myo {

/// How one marker of a trial compares. Steady state: the mean over the last fifth of the samples.
struct MarkerScore {
    std::string name;
    double rms_m = 0.0;                       // over its compared coordinates
    Eigen::Vector3d steady_simulated_m;       // position, or displacement from rest, as compared
    Eigen::Vector3d steady_measured_m;
    double steady_error_m = 0.0;              // length of their difference
};

struct TrialScore {
    std::string name;
    TrialRole role = TrialRole::fit;
    double rms_m = 0.0;
    std::vector<MarkerScore> markers;
};
TrialScore score(const Study& study, std::size_t trial, const TrialPrediction& prediction);

/// All trials run once with the same values.
struct StudyRun {
    StudyValues values;
    std::vector<TrialPrediction> predictions;   // per trial
    std::vector<TrialScore> scores;             // of the trials that completed
    double fit_rms_m = 0.0;                     // over the fit trials
    double validation_rms_m = 0.0;              // over the validation trials; NaN when there are none
    double seconds = 0.0;
    std::string failure;                        // why a trial did not complete; empty when all did

    bool ok() const { return failure.empty(); }
};

/// Runs the trials (all, or the named one) on the study's threads. Trials that were not asked for have status not_run.
StudyRun run_study(const Study& study, const StudyValues& values, const Progress& progress = {}, const std::string& only_trial = {});

/// The declared fit: what the experiment leaves unknown, from its fit trials.
struct Calibration {
    std::vector<StudyParameter> parameters;
    LeastSquaresReport fit;
    StudyRun before;
    StudyRun after;
    double seconds = 0.0;
    std::vector<std::string> warnings;
};

/// names: restricts which material parameters are moved (youngs_modulus, damping); empty: what the experiment says.
Calibration calibrate_study(const Study& study, const std::vector<std::string>& names = {}, const Progress& progress = {});

/// Levels of validation trials, from the condition by a curve through the fit trials' levels.
/// Where the conditions do not tell (none shared, or a single value), the mean of the levels.
StudyValues with_predicted_levels(const Study& study, StudyValues values);

}  // namespace myo
