#pragma once

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

#include "commands/backend.hpp"

namespace myo::ui::commands {

/// Differences between a marker's simulated and measured path. NaN where nothing can be compared.
struct MarkerError {
    std::string name;
    double rms_m = std::numeric_limits<double>::quiet_NaN();      // over all three coordinates [m]
    double largest_m = std::numeric_limits<double>::quiet_NaN();  // largest distance [m]
    Eigen::Vector3d rms_axis_m = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());  // per axis [m]
    // Largest magnitude per axis [m].
    Eigen::Vector3d largest_axis_m = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    // Mean of simulated - measured per axis [m].
    Eigen::Vector3d bias_m = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    double seen = 0.0;  // share of the samples in which the marker was measured, 0 to 1
};

/// Errors of all markers of the scene from the start of the motion (t = 0) on.
///
/// @param simulated  run of the same trial; null: only `seen` is computed
std::vector<MarkerError> marker_errors(const Scene& scene, const SceneTrial& trial, const SimulatedTrial* simulated);

/// Root mean square of simulated - measured over the three coordinates of one marker [m]. NaN if nothing can be
/// compared.
///
/// @param first_s, last_s  range of times, ends included [s]
double marker_rms_m(const SceneTrial& trial, const SimulatedTrial* simulated, std::size_t marker, double first_s,
                    double last_s);

}  // namespace myo::ui::commands
