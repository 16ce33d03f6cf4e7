#pragma once

#include <vector>

#include "prediction/run_trials.hpp"

namespace myo::test {

/// A prediction that misses its recording by the same vector [m] at all markers and samples. Nothing is simulated: its
/// trace has six states, in which the whole mesh moves at 1 m/s along the vector's direction.
inline prediction::TrialPrediction missed_by(const setup::Setup& setup, std::size_t trial,
                                             const Eigen::Vector3d& miss_m) {
    const setup::PreparedTrial& data = setup.trials[trial];
    prediction::TrialPrediction prediction;
    prediction.status = dynamics::RunStatus::complete;
    for (const Eigen::Matrix3Xd& track : data.measured.tracks) {
        prediction.positions_m.emplace_back(track.colwise() + miss_m);
        prediction.start_m.emplace_back(track.col(0) + miss_m);
        prediction.residual_m.emplace_back(Eigen::Matrix3Xd::Zero(3, track.cols()).colwise() + miss_m);
    }
    const Eigen::Matrix3Xd& X = setup.mesh.mesh.nodes;
    const Eigen::Vector3d velocity = miss_m.stableNormalized();
    dynamics::Trace& trace = prediction.trace;
    trace.status = dynamics::RunStatus::complete;
    for (int k = 0; k < 6; ++k) {
        const double time_s = 0.02 * k;
        trace.times_s.push_back(time_s);
        trace.positions.emplace_back(X.colwise() + time_s * velocity);
        trace.velocities.emplace_back(Eigen::Matrix3Xd::Zero(3, X.cols()).colwise() + velocity);
    }
    trace.newton_iterations = 10;
    return prediction;
}

/// A scored run of all trials, each of which misses its recording by a vector of the given length [m].
inline prediction::SetupRun run_missed_by(const setup::Setup& setup, const std::vector<Eigen::Vector3d>& misses_m) {
    std::vector<prediction::TrialPrediction> predictions;
    std::vector<std::size_t> trials;
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        predictions.push_back(missed_by(setup, t, misses_m[t]));
        trials.push_back(t);
    }
    return prediction::scored_run(setup, prediction::declared_values(setup), std::move(predictions), trials);
}

/// Marks a trial of a run as failed, with scores as after a real failure.
inline prediction::SetupRun with_failure(const setup::Setup& setup, prediction::SetupRun run, std::size_t trial,
                                         const std::string& message) {
    run.predictions[trial] = {};
    run.predictions[trial].status = dynamics::RunStatus::failed;
    run.predictions[trial].message = message;
    std::vector<std::size_t> trials;
    for (std::size_t t = 0; t < setup.trials.size(); ++t) trials.push_back(t);
    return prediction::scored_run(setup, run.values, std::move(run.predictions), trials);
}

}  // namespace myo::test
