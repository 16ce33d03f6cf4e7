#pragma once

#include <Eigen/Core>

#include <vector>

#include "base/result.hpp"

namespace myo::measurement {

/// How much later the same motion is in one record than in another.
struct TimeAlignment {
    double delay_s = 0.0;      // time in the record less time in the reference
    double correlation = 0.0;  // there, -1 to 1
};

/// The delay with the greatest correlation of the markers' displacements, all coordinates together, between samples by
/// a parabola.
///
/// Before its first sample the reference rests in its first place, as a body does that is let go; after its last it has
/// no value.
/// @param reference_time_s, reference  ascending, and tracks 3 x T per marker [m], as a simulation gives them
/// @param record_time_s, record        of the same markers; NaN = not seen
/// Errors: different numbers of markers; fewer than eight samples; nothing moves.
/// Source: Knapp, Carter 1976, "The generalized correlation method for estimation of time delay" (with equal weights).
Result<TimeAlignment> align_in_time(const Eigen::VectorXd& reference_time_s,
                                    const std::vector<Eigen::Matrix3Xd>& reference,
                                    const Eigen::VectorXd& record_time_s, const std::vector<Eigen::Matrix3Xd>& record);

}  // namespace myo::measurement
