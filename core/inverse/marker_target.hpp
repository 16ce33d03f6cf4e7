#pragma once

#include <Eigen/Core>

#include <vector>

#include "measurement/observe.hpp"
#include "sensitivity/adjoint_run.hpp"

namespace myo::inverse {

/// How the cameras' frame and clock stand to the model's: what is at x at time t is seen at R(rotation) x +
/// translation, stamped t + start_shift. Displacements from the start are turned alone.
struct MarkerPlacement {
    Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d rotation_rad = Eigen::Vector3d::Zero();  // see small_rotation()
    double start_shift_s = 0.0;
};

/// Where markers shall be.
struct MarkerTarget {
    measurement::MarkerSet markers;
    Eigen::VectorXd times_s;                    // T, 0 is the start
    std::vector<Eigen::Matrix3Xd> positions_m;  // per marker 3 x T; NaN: anywhere
    bool from_start = false;                    // positions are displacements from where the marker is at t = 0
    MarkerPlacement placement;

    /// Coordinates that are compared.
    Eigen::Index coordinates() const;
};

/// Marker as placed minus target, 3 x T per marker [m]; NaN where there is no target.
std::vector<Eigen::Matrix3Xd> target_residuals(const MarkerTarget& target, const sensitivity::NodeMotion& motion);

/// The same of a run with tangents, with the derivative of the residuals with respect to each parameter:
/// [parameter][marker] 3 x T.
struct SensitiveResiduals {
    std::vector<Eigen::Matrix3Xd> residuals_m;
    std::vector<std::vector<Eigen::Matrix3Xd>> tangents;
};
SensitiveResiduals target_residuals(const MarkerTarget& target, const sensitivity::SensitiveTrace& run);

/// Mean square of the residuals' coordinates [m2] and its derivative with respect to the motion of the markers' nodes.
sensitivity::MotionLoss mean_square(const MarkerTarget& target, const sensitivity::NodeMotion& motion);

/// The derivative of mean_square() with respect to the placement, per unit of each of its fields.
MarkerPlacement mean_square_by_placement(const MarkerTarget& target, const sensitivity::NodeMotion& motion);

/// mean_square() as the loss of a run. The target must outlive it.
sensitivity::LossOfMotion mean_square_of(const MarkerTarget& target);

}  // namespace myo::inverse
