#include "setup/beginning.hpp"

#include <algorithm>

namespace myo::setup {
namespace {

/// Cuts every array of a recording that has one entry per sample.
void keep_samples(measurement::Recording& recording, Eigen::Index count) {
    recording.time_s.conservativeResize(count);
    for (Eigen::Matrix3Xd& track : recording.tracks) track.conservativeResize(Eigen::NoChange, count);
    for (Eigen::VectorXd& residual : recording.residual_m) residual.conservativeResize(count);
}

}  // namespace

void keep_beginning(PreparedTrial& trial, Eigen::Index samples) {
    if (samples >= trial.measured.sample_count()) return;
    const double interval_s = sampling_interval_s(trial);
    keep_samples(trial.measured, samples);
    // One interval of reserve, so that a start which a fit moves later still has simulated data under the last sample.
    trial.options.end_s = std::min(trial.options.end_s, trial.measured.time_s(samples - 1) + interval_s);
}

}  // namespace myo::setup
