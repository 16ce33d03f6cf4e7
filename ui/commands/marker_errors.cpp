#include "commands/marker_errors.hpp"

#include <algorithm>
#include <cmath>

namespace myo::ui::commands {

namespace {

/// Sums over the samples of a marker from t = 0 on.
struct ErrorSums {
    Eigen::Vector3d differences = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
    Eigen::Vector3d largest_axis = Eigen::Vector3d::Zero();
    double largest = 0.0;
    int samples = 0, seen = 0, compared = 0;
};

/// @param simulated  null: nothing to compare with
ErrorSums error_sums(const Eigen::VectorXd& time_s, const Eigen::Matrix3Xd& measured,
                     const Eigen::Matrix3Xd* simulated) {
    ErrorSums sums;
    for (Eigen::Index t = 0; t < measured.cols(); ++t) {
        // Before the start the body is held, so these samples say nothing about the motion.
        if (time_s(t) < 0.0) continue;
        ++sums.samples;
        if (!measured.col(t).allFinite()) continue;
        ++sums.seen;
        // An occluded marker has NaN in all coordinates.
        if (simulated == nullptr || !simulated->col(t).allFinite()) continue;
        const Eigen::Vector3d difference = simulated->col(t) - measured.col(t);
        sums.differences += difference;
        sums.squares += difference.cwiseAbs2();
        sums.largest_axis = sums.largest_axis.cwiseMax(difference.cwiseAbs());
        sums.largest = std::max(sums.largest, difference.norm());
        ++sums.compared;
    }
    return sums;
}

}  // namespace

std::vector<MarkerError> marker_errors(const Scene& scene, const SceneTrial& trial, const SimulatedTrial* simulated) {
    std::vector<MarkerError> errors;
    for (std::size_t m = 0; m < scene.markers.size() && m < trial.measured.size(); ++m) {
        MarkerError error;
        error.name = scene.markers[m].name;
        const Eigen::Matrix3Xd& measured = trial.measured[m];
        // A run of another version of the experiment may have other markers or samples.
        const bool predicted = simulated && m < simulated->markers.size() &&
                               simulated->markers[m].cols() == measured.cols();
        const ErrorSums sums = error_sums(trial.time_s, measured, predicted ? &simulated->markers[m] : nullptr);
        if (sums.samples > 0) error.seen = static_cast<double>(sums.seen) / sums.samples;
        if (sums.compared > 0) {
            error.rms_axis_m = (sums.squares / sums.compared).cwiseSqrt();
            // over coordinates, not distances: three per sample
            error.rms_m = std::sqrt(sums.squares.sum() / (3.0 * sums.compared));
            error.bias_m = sums.differences / sums.compared;
            error.largest_axis_m = sums.largest_axis;
            error.largest_m = sums.largest;
        }
        errors.push_back(error);
    }
    return errors;
}

double marker_rms_m(const SceneTrial& trial, const SimulatedTrial* simulated, std::size_t marker, double first_s,
                    double last_s) {
    double squares = 0.0;
    int count = 0;
    const bool known = simulated && marker < trial.measured.size() && marker < simulated->markers.size() &&
                       simulated->markers[marker].cols() == trial.time_s.size();
    for (Eigen::Index t = 0; known && t < trial.time_s.size(); ++t) {
        if (trial.time_s(t) < first_s || trial.time_s(t) > last_s) continue;
        const Eigen::Vector3d difference = simulated->markers[marker].col(t) - trial.measured[marker].col(t);
        if (!difference.allFinite()) continue;
        squares += difference.squaredNorm();
        ++count;
    }
    return count > 0 ? std::sqrt(squares / (3.0 * count)) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace myo::ui::commands
