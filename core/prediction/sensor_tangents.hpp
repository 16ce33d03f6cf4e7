#pragma once

#include <Eigen/Core>

#include <vector>

#include "prediction/prediction.hpp"

namespace myo::prediction {

/// Predicted readings of the sensors of a trial minus the recorded ones, one vector per series, in its unit; NaN where
/// nothing is compared.
///
/// @param affected  of the same values
/// @param trace     of its run
std::vector<Eigen::VectorXd> sensor_residuals(const setup::Setup& setup, std::size_t trial,
                                              const ParameterValues& values, const effect::Affected& affected,
                                              const dynamics::Trace& trace);

/// Derivative of sensor_residuals() with respect to a parameter, by central differences of two further runs.
///
/// A reading depends on the motion of all nodes, of which tangents are not kept.
/// @return  empty if a run failed
std::vector<Eigen::VectorXd> sensor_tangents(const setup::Setup& setup, std::size_t trial,
                                             const ParameterValues& values, const ModelParameter& parameter,
                                             const Progress& progress);

}  // namespace myo::prediction
