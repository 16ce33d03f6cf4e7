#pragma once

#include <Eigen/Core>

#include <vector>

#include "measurement/recording.hpp"

namespace myo::measurement {

/// Two markers that carry each other's name from a time on.
struct MarkerSwap {
    std::size_t first = 0, second = 0;
    double from_s = 0.0;
};

/// A marker that sits elsewhere from a time on.
struct MarkerShift {
    std::size_t marker = 0;
    Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();  // mesh frame
    double from_s = 0.0;
};

/// How a recording differs from what it says of itself.
struct ObservationError {
    double clock_offset_s = 0.0;  // a sample stamped t was taken at t + offset
    double rate_error = 0.0;      // the true rate is the declared one times 1 + error
    double scale_error = 0.0;     // all coordinates are times 1 + error, about the mesh origin
    std::vector<MarkerSwap> swaps;
    std::vector<MarkerShift> shifts;
};

/// When samples stamped with these times were taken [s].
Eigen::VectorXd true_times(const ObservationError& error, const Eigen::VectorXd& stamped_s);

/// What cameras report of tracks (per marker 3 x T [m], samples stamped `stamped_s`): shifts, then swaps, then the
/// scale.
std::vector<Eigen::Matrix3Xd> seen_tracks(const ObservationError& error, std::vector<Eigen::Matrix3Xd> tracks,
                                          const Eigen::VectorXd& stamped_s);

/// The same of derivatives of the tracks, for which shifts are constants.
std::vector<Eigen::Matrix3Xd> seen_tangents(const ObservationError& error, std::vector<Eigen::Matrix3Xd> tangents,
                                            const Eigen::VectorXd& stamped_s);

}  // namespace myo::measurement
