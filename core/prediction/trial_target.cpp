#include "prediction/trial_target.hpp"

#include <algorithm>
#include <limits>

#include "base/text.hpp"

namespace myo::prediction {

using Eigen::Index;
using Eigen::Matrix3Xd;

namespace {

/// Measured track in the frame of the mount, where the markers of a motion are. Distances are the same in both frames.
/// Displacements are those from the start, so that a translation alone comes off them.
void see_from_mount(const model::MountMotion& mount, const Eigen::VectorXd& times_s, bool from_start,
                    Matrix3Xd& track) {
    const model::MountPose start = mount.at(0.0);
    for (Index t = 0; t < track.cols(); ++t) {
        const model::MountPose pose = mount.at(times_s(t));
        if (from_start)
            track.col(t) -= pose.place_m - start.place_m;
        else
            track.col(t) = (pose.rotation.transpose() * (track.col(t) - pose.place_m) + pose.pivot_m).eval();
    }
}

}  // namespace

model::MountMotionPointer declared_mount(const setup::Setup& setup, std::size_t index) {
    if (!setup.trials[index].mount && setup.experiment.effects.empty()) return nullptr;
    return affected_trial(setup, index, declared_values(setup)).observation_error.mount;
}

inverse::MarkerTarget trial_target(const setup::Setup& setup, std::size_t index, double until_s) {
    const setup::PreparedTrial& trial = setup.trials[index];
    inverse::MarkerTarget target;
    target.markers = setup.markers;
    target.from_start = setup.experiment.markers.compare == experiment::Comparison::displacement;
    const Eigen::VectorXd& times = trial.measured.time_s;
    const Index first = trial.first_sample;
    const Index end = std::upper_bound(times.begin(), times.end(), until_s) - times.begin();
    const Index count = std::max<Index>(0, end - first);
    target.times_s = times.segment(std::min(first, times.size()), count);
    const model::MountMotionPointer mount = declared_mount(setup, index);
    for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
        Matrix3Xd track = trial.measured.tracks[m].middleCols(std::min(first, times.size()), count);
        if (target.from_start) track.colwise() -= trial.reference_m[m];
        if (mount) see_from_mount(*mount, target.times_s, target.from_start, track);
        // A sample with an occluded coordinate is excluded as a whole; a goal may name some coordinates only.
        for (Index t = 0; t < count && trial.goal_weights.empty(); ++t)
            if (!track.col(t).allFinite()) track.col(t).setConstant(std::numeric_limits<double>::quiet_NaN());
        target.positions_m.push_back(std::move(track));
    }
    for (const Matrix3Xd& weights : trial.goal_weights)
        target.weights.emplace_back(weights.middleCols(std::min(first, times.size()), count));
    return target;
}

TrialPrediction prediction_of(const setup::Setup& setup, std::size_t index, const sensitivity::NodeMotion& motion,
                              const inverse::MarkerPlacement& placement) {
    const setup::PreparedTrial& trial = setup.trials[index];
    inverse::MarkerTarget all = trial_target(setup, index, std::numeric_limits<double>::infinity());
    all.placement = placement;
    const std::vector<Matrix3Xd> compared = inverse::target_residuals(all, motion);
    TrialPrediction result;
    result.status = dynamics::RunStatus::complete;
    measurement::ObservationError seen;
    seen.mount = declared_mount(setup, index);
    const Eigen::VectorXd &times = trial.measured.time_s, start_s = Eigen::VectorXd::Zero(1);
    result.positions_m = measurement::laboratory_tracks(
        seen, measurement::observe(motion, setup.markers, times).positions, times);
    for (const Matrix3Xd& start :
         measurement::laboratory_tracks(seen, measurement::observe(motion, setup.markers, start_s).positions, start_s))
        result.start_m.emplace_back(start.col(0));
    for (const Matrix3Xd& residual : compared) {
        Matrix3Xd whole = Matrix3Xd::Constant(3, trial.measured.sample_count(),
                                              std::numeric_limits<double>::quiet_NaN());
        // The target starts at first_sample; earlier samples stay NaN so that indices match the recording.
        whole.rightCols(residual.cols()) = residual;
        result.residual_m.push_back(std::move(whole));
    }
    return result;
}

ParameterValues placed_values(const setup::Setup& setup, const inverse::MarkerPlacement& placement) {
    ParameterValues values = declared_values(setup);
    // Levels would overwrite the signals that replaced them.
    for (auto& levels : values.levels) levels.clear();
    values.translation_m = placement.translation_m;
    values.rotation_rad = placement.rotation_rad;
    return values;
}

Result<std::size_t> find_trial(const experiment::Experiment& experiment, const std::string& name) {
    std::vector<std::string> names;
    for (std::size_t t = 0; t < experiment.trials.size(); ++t) {
        names.push_back(experiment.trials[t].name);
        if (name.empty() ? experiment.trials[t].role == experiment::TrialRole::fit : names.back() == name) return t;
    }
    if (name.empty()) return std::size_t{0};  // none has a recording to fit
    const std::string near = closest_word(name, names);
    return Error{"no trial '" + name + "'; " +
                     (near.empty() ? "the experiment has " + join(names) : "did you mean '" + near + "'?"),
                 "--trial"};
}

setup::Setup with_one_trial(setup::Setup setup, std::size_t trial) {
    setup.trials = {std::move(setup.trials[trial])};
    setup.experiment.trials = {setup.experiment.trials[trial]};
    if (setup.trials.front().role == experiment::TrialRole::simulate) return setup;
    setup.trials.front().role = experiment::TrialRole::fit;
    setup.experiment.trials.front().role = experiment::TrialRole::fit;
    return setup;
}

}  // namespace myo::prediction
