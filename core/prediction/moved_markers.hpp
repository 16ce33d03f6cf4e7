#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

#include "measurement/observe.hpp"
#include "prediction/prediction.hpp"

namespace myo::prediction {

/// Whether displacements are compared, not positions.
bool by_displacement(const setup::Setup& setup);

/// Simulation times of the samples of a trial [s]. A later start of the motion means an earlier simulation time.
Eigen::VectorXd motion_times(const setup::PreparedTrial& trial, const measurement::ObservationError& error,
                             double start_shift_s);

/// Markers where the effects and the values place them.
measurement::MarkerSet markers_of(const setup::Setup& setup, const measurement::ObservationError& error,
                                  const ParameterValues& values);

/// Markers of a run with their tangents, at the sample times and at t = 0.
struct SensitiveMotion {
    measurement::ObservationError error;
    measurement::SensitiveTracks tracks, origin;
};

/// @param times_s  see motion_times()
SensitiveMotion sensitive_motion(const measurement::ObservationError& error, const sensitivity::SensitiveTrace& run,
                                 const measurement::MarkerSet& markers, const Eigen::VectorXd& times_s);

/// Tangent of the residuals along row `row` of the tangents of a run, per marker, 3 x samples [m per unit].
///
/// @param index  of the trial
std::vector<Eigen::Matrix3Xd> moved_tangent(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                                            const SensitiveMotion& motion, std::size_t row);

}  // namespace myo::prediction
