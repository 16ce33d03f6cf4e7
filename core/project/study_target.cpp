#include "project/study_target.hpp"

#include <algorithm>
#include <limits>

#include "base/text.hpp"

namespace myo {

using Eigen::Index;
using Eigen::Matrix3Xd;

MarkerTarget trial_target(const Study& study, std::size_t index, double until_s) {
    const StudyTrial& trial = study.trials[index];
    MarkerTarget target;
    target.markers = study.markers;
    target.from_start = study.experiment.markers.compare == Comparison::displacement;
    const Eigen::VectorXd& times = trial.measured.time_s;
    const Index first = trial.first_sample;
    const Index end = std::upper_bound(times.begin(), times.end(), until_s) - times.begin();
    const Index count = std::max<Index>(0, end - first);
    target.times_s = times.segment(std::min(first, times.size()), count);
    for (std::size_t m = 0; m < study.marker_names.size(); ++m) {
        Matrix3Xd track = trial.measured.tracks[m].middleCols(std::min(first, times.size()), count);
        if (target.from_start) track.colwise() -= trial.reference_m[m];
        // A coordinate alone says nothing that could be trusted.
        for (Index t = 0; t < count; ++t)
            if (!track.col(t).allFinite()) track.col(t).setConstant(std::numeric_limits<double>::quiet_NaN());
        target.positions_m.push_back(std::move(track));
    }
    return target;
}

TrialPrediction prediction_of(const Study& study, std::size_t index, const NodeMotion& motion,
                              const MarkerPlacement& placement) {
    const StudyTrial& trial = study.trials[index];
    MarkerTarget all = trial_target(study, index, std::numeric_limits<double>::infinity());
    all.placement = placement;
    const std::vector<Matrix3Xd> compared = target_residuals(all, motion);
    TrialPrediction result;
    result.status = RunStatus::complete;
    result.positions_m = observe(motion, study.markers, trial.measured.time_s).positions;
    for (const Matrix3Xd& start : observe(motion, study.markers, Eigen::VectorXd::Zero(1)).positions) result.start_m.emplace_back(start.col(0));
    for (const Matrix3Xd& residual : compared) {
        Matrix3Xd whole = Matrix3Xd::Constant(3, trial.measured.sample_count(), std::numeric_limits<double>::quiet_NaN());
        whole.rightCols(residual.cols()) = residual;
        result.residual_m.push_back(std::move(whole));
    }
    return result;
}

StudyValues placed_values(const Study& study, const MarkerPlacement& placement) {
    StudyValues values = declared_values(study);
    for (auto& levels : values.levels) levels.clear();
    values.translation_m = placement.translation_m;
    values.rotation_rad = placement.rotation_rad;
    return values;
}

Result<std::size_t> find_trial(const Experiment& experiment, const std::string& name) {
    std::vector<std::string> names;
    for (std::size_t t = 0; t < experiment.trials.size(); ++t) {
        names.push_back(experiment.trials[t].name);
        if (name.empty() ? experiment.trials[t].role == TrialRole::fit : names.back() == name) return t;
    }
    const std::string near = closest_word(name, names);
    return Error{"no trial '" + name + "'; " + (near.empty() ? "the experiment has " + join(names) : "did you mean '" + near + "'?"), "--trial"};
}

Study with_one_trial(Study study, std::size_t trial) {
    study.trials = {std::move(study.trials[trial])};
    study.trials.front().role = TrialRole::fit;
    study.experiment.trials = {study.experiment.trials[trial]};
    study.experiment.trials.front().role = TrialRole::fit;
    return study;
}

}  // namespace myo
