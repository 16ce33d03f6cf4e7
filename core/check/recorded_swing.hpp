#pragma once

#include <Eigen/Core>

#include <vector>

#include "setup/setup.hpp"

namespace myo::check {

/// A motion to and fro that a recording shows.
struct RecordedSwing {
    int turns = 0;              // below 3: none is seen
    double frequency_Hz = 0.0;  // by the median time between two turns
};

/// Times [s] at which a coordinate [m] turns back by more than `least_m`; samples that are not finite are passed over.
std::vector<double> turning_times(const Eigen::VectorXd& time_s, const Eigen::VectorXd& x_m, double least_m);

/// When the loads and signals of a trial have last changed [s]; 0 where nothing changes after its start. The last
/// twentieth of a signal's range does not count: logs are noisy.
double last_change_s(const model::Model& model);

/// How the coordinate that moves most swings from a time on, as far as it stands out of noise and travel.
RecordedSwing recorded_swing(const setup::PreparedTrial& trial, double from_s, double noise_m);

}  // namespace myo::check
