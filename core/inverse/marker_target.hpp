#pragma once

#include <Eigen/Core>

#include <vector>

#include "measurement/observe.hpp"
#include "sensitivity/adjoint_run.hpp"

namespace myo::inverse {

/// Camera frame and clock relative to the model: a point at x at time t is observed at R(rotation) x + translation with
/// the time stamp t + start_shift. Displacements from the start are only rotated.
struct MarkerPlacement {
    Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d rotation_rad = Eigen::Vector3d::Zero();  // rotation vector, see small_rotation()
    double start_shift_s = 0.0;
};

/// Target positions of markers.
struct MarkerTarget {
    measurement::MarkerSet markers;
    Eigen::VectorXd times_s;                    // T time stamps; 0 is the start
    std::vector<Eigen::Matrix3Xd> positions_m;  // per marker 3 x T; NaN: not compared
    bool from_start = false;                    // positions are displacements from the marker position at t = 0
    MarkerPlacement placement;
    /// Weights of the squared coordinates in mean_square(), like positions_m; empty: 1 each. best_placement() takes no
    /// notice.
    std::vector<Eigen::Matrix3Xd> weights{};

    /// Number of compared (finite) coordinates.
    Eigen::Index coordinates() const;
};

/// Placed marker minus target, per marker 3 x T [m]; NaN where there is no target.
std::vector<Eigen::Matrix3Xd> target_residuals(const MarkerTarget& target, const sensitivity::NodeMotion& motion);

/// Residuals with their derivatives, [parameter][marker] 3 x T [m per unit].
struct SensitiveResiduals {
    std::vector<Eigen::Matrix3Xd> residuals_m;
    std::vector<std::vector<Eigen::Matrix3Xd>> tangents;
};
/// Residuals of a run with tangents of the marker nodes.
SensitiveResiduals target_residuals(const MarkerTarget& target, const sensitivity::SensitiveTrace& run);

/// Weights of the squared coordinates with sum 1, per marker 3 x T; 0 where there is no target.
std::vector<Eigen::Matrix3Xd> shares_of_coordinates(const MarkerTarget& target);

/// Weighted mean square of the residual coordinates [m2] and its derivative with respect to the motion of the marker
/// nodes. Asserts that coordinates() > 0.
sensitivity::MotionLoss mean_square(const MarkerTarget& target, const sensitivity::NodeMotion& motion);

/// Derivative of mean_square() with respect to each field of the placement.
MarkerPlacement mean_square_by_placement(const MarkerTarget& target, const sensitivity::NodeMotion& motion);

/// mean_square() as the loss of a run. Keeps a reference to the target.
sensitivity::LossOfMotion mean_square_of(const MarkerTarget& target);

}  // namespace myo::inverse
