#pragma once

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

#include "commands/backend.hpp"

namespace myo::ui::commands {

/// How a marker's simulated way differs from the measured one. NaN where nothing can be compared.
struct MarkerError {
    std::string name;
    double rms_m = std::numeric_limits<double>::quiet_NaN();      // over all three coordinates
    double largest_m = std::numeric_limits<double>::quiet_NaN();  // distance
    Eigen::Vector3d rms_axis_m = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    Eigen::Vector3d largest_axis_m = Eigen::Vector3d::Constant(
        std::numeric_limits<double>::quiet_NaN());  // of the magnitudes
    Eigen::Vector3d bias_m = Eigen::Vector3d::Constant(
        std::numeric_limits<double>::quiet_NaN());  // mean of simulated less measured
    double seen = 0.0;                              // share of the samples in which the marker was measured
};

/// From the start of the motion (t = 0) on, per marker of the scene.
/// @param simulated  of the same trial; null: only what was seen is told
std::vector<MarkerError> marker_errors(const Scene& scene, const SceneTrial& trial, const SimulatedTrial* simulated);

/// Root mean square of simulated less measured over the three coordinates of a marker for first_s <= time <= last_s
/// [m]; NaN where nothing can be compared.
double marker_rms_m(const SceneTrial& trial, const SimulatedTrial* simulated, std::size_t marker, double first_s,
                    double last_s);

}  // namespace myo::ui::commands
