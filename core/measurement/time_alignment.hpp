#pragma once

#include <Eigen/Core>

#include <vector>

#include "base/result.hpp"

namespace myo::measurement {

/// Delay between two recordings of the same motion.
struct TimeAlignment {
    double delay_s = 0.0;      // time in the record minus time in the reference
    double correlation = 0.0;  // at this delay, -1 ... 1
};

/// Delay that maximises the correlation of the marker displacements, pooled over all coordinates and refined between
/// samples by a parabola.
///
/// Before its first sample the reference is assumed at rest in its first position, as for a released body; after its
/// last sample it has no value.
/// @param reference_time_s, reference  ascending times [s], tracks 3 x T per marker [m], e.g. from a simulation
/// @param record_time_s, record        the same markers; NaN where occluded
/// Errors: different numbers of markers; fewer than eight samples; no motion.
/// Source: Knapp, Carter 1976, "The generalized correlation method for estimation of time delay" (with equal weights).
Result<TimeAlignment> align_in_time(const Eigen::VectorXd& reference_time_s,
                                    const std::vector<Eigen::Matrix3Xd>& reference,
                                    const Eigen::VectorXd& record_time_s, const std::vector<Eigen::Matrix3Xd>& record);

}  // namespace myo::measurement
