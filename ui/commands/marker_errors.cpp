#include "commands/marker_errors.hpp"

#include <algorithm>
#include <cmath>

namespace myo::ui::commands {

std::vector<MarkerError> marker_errors(const Scene& scene, const SceneTrial& trial, const SimulatedTrial* simulated) {
    std::vector<MarkerError> errors;
    for (std::size_t m = 0; m < scene.markers.size() && m < trial.measured.size(); ++m) {
        MarkerError error;
        error.name = scene.markers[m].name;
        const Eigen::Matrix3Xd& measured = trial.measured[m];
        const bool predicted = simulated && m < simulated->markers.size() &&
                               simulated->markers[m].cols() == measured.cols();
        Eigen::Vector3d sum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();
        Eigen::Vector3d largest_axis = Eigen::Vector3d::Zero();
        double largest = 0.0;
        int seen = 0, count = 0, samples = 0;
        for (Eigen::Index t = 0; t < measured.cols(); ++t) {
            // Before the start the body is held, so these samples say nothing about the motion.
            if (trial.time_s(t) < 0.0) continue;
            ++samples;
            if (!measured.col(t).allFinite()) continue;
            ++seen;
            // An occluded marker has NaN in all coordinates.
            if (!predicted || !simulated->markers[m].col(t).allFinite()) continue;
            const Eigen::Vector3d difference = simulated->markers[m].col(t) - measured.col(t);
            sum += difference;
            squares += difference.cwiseAbs2();
            largest_axis = largest_axis.cwiseMax(difference.cwiseAbs());
            largest = std::max(largest, difference.norm());
            ++count;
        }
        if (samples > 0) error.seen = static_cast<double>(seen) / samples;
        if (count > 0) {
            error.rms_axis_m = (squares / count).cwiseSqrt();
            // over coordinates, not distances: three per sample
            error.rms_m = std::sqrt(squares.sum() / (3.0 * count));
            error.bias_m = sum / count;
            error.largest_axis_m = largest_axis;
            error.largest_m = largest;
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
