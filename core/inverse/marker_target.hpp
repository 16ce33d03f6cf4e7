#pragma once

#include <Eigen/Core>

#include <vector>

#include "measurement/observe.hpp"
#include "sensitivity/adjoint_run.hpp"

namespace myo {

/// Where markers shall be.
struct MarkerTarget {
    MarkerSet markers;
    Eigen::VectorXd times_s;                     // T, 0 is the start
    std::vector<Eigen::Matrix3Xd> positions_m;   // per marker 3 x T; NaN: anywhere
    bool from_start = false;                     // positions are displacements from where the marker is at t = 0

    /// Coordinates that are compared.
    Eigen::Index coordinates() const;
};

/// Marker minus target, 3 x T per marker [m]; NaN where there is no target.
std::vector<Eigen::Matrix3Xd> target_residuals(const MarkerTarget& target, const NodeMotion& motion);

/// Mean square of the residuals' coordinates [m2] and its derivative with respect to the motion of the markers' nodes.
MotionLoss mean_square(const MarkerTarget& target, const NodeMotion& motion);

/// mean_square() as the loss of a run. The target must outlive it.
LossOfMotion mean_square_of(const MarkerTarget& target);

}  // namespace myo
