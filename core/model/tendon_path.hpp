#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo::model {

/// Path of a thread through its guides, motor's end first: straight legs between neighbouring guides.
struct TendonPath {
    std::vector<Eigen::Vector3d> direction;  // of each leg, unit, from the motor to the anchor
    Eigen::VectorXd length;                  // of each leg [m]
    double total = 0.0;                      // [m]

    std::size_t legs() const { return direction.size(); }
};
/// Path through points [m], motor's end first; neighbours must not coincide.
TendonPath tendon_path(const std::vector<Eigen::Vector3d>& points);

/// Derivatives of the legs' lengths along motions dp of the guides.
Eigen::VectorXd lengthening(const TendonPath& path, const std::vector<Eigen::Vector3d>& dp);

/// Derivative of the direction of a leg by the vector between its ends [1/m].
Eigen::Matrix3d turning(const TendonPath& path, std::size_t leg);

/// Forces on the guides for legs with these tensions, times -1: derivative of sum of tension times length at fixed
/// tensions.
std::vector<Eigen::Vector3d> pulls_on_guides(const TendonPath& path, const Eigen::VectorXd& tensions);

/// Capstan law: tensions of the legs over that at the motor, exp(-friction times the bends passed since the motor).
///
/// A bend is the angle b between two legs, smoothed to sqrt(b^2 + b0^2) - b0 with b0 = 1e-3 rad, so that a straight
/// thread has derivatives.
/// @param friction  coefficient; negative while the thread pays out
/// Source: Euler 1769; Eytelwein 1808 (belt friction).
Eigen::VectorXd capstan_factors(const TendonPath& path, double friction);

/// Derivatives of capstan_factors() along motions dp of the guides, and along the coefficient.
Eigen::VectorXd capstan_changes(const TendonPath& path, double friction, const Eigen::VectorXd& factors,
                                const std::vector<Eigen::Vector3d>& dp, double friction_change);
/// Transpose of capstan_changes() with respect to dp: adds to the adjoints of the guides' positions.
void pull_by_capstan(const TendonPath& path, double friction, const Eigen::VectorXd& factors,
                     const Eigen::VectorXd& by_factor, std::vector<Eigen::Vector3d>& by_position);

}  // namespace myo::model
