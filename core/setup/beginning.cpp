#include "setup/beginning.hpp"

#include <algorithm>

namespace myo::setup {
namespace {

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
    trial.options.end_s = std::min(trial.options.end_s, trial.measured.time_s(samples - 1) + interval_s);
}

}  // namespace myo::setup
