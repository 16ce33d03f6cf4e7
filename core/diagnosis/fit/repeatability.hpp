#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

#include "diagnosis/diagnosis_policy.hpp"
#include "prediction/prediction.hpp"

namespace myo::diagnosis {

/// What repeated trials leave between each other: a floor for the residual of any model, since none tells them apart.
struct Repeatability {
    std::vector<std::pair<std::size_t, std::size_t>> repeats;  // indices of the setup's trials
    Eigen::VectorXd marker_rms_m;  // per marker and coordinate, of one trial about the mean of both [m]; NaN: none seen
    double rms_m = 0.0;            // of all markers; 0: nothing was repeated

    bool known() const { return !repeats.empty(); }
};

/// Differences of the recordings of repeated trials: of those whose predicted motions agree far below the noise, while
/// the body moves or is held. A shift in time is taken out first, and a rigid displacement unless the registration is
/// known; the variance of one trial is half that of the difference.
/// @param predictions  of all trials with the same values; failed ones are skipped
Repeatability repeatability(const setup::Setup& setup, const std::vector<prediction::TrialPrediction>& predictions,
                            const RepeatPolicy& policy);

}  // namespace myo::diagnosis
