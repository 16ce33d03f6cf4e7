#include "inverse/best_placement.hpp"

#include "inverse/bounded_step.hpp"
#include "measurement/rigid_motion.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using Vector6d = Eigen::Matrix<double, 6, 1>;

struct BestPlacementPolicy {
    /// Small rotations converge quadratically: three iterations reach rounding.
    int max_steps = 8;
    double converged = 1e-12;  // norm of a change relative to the bounds
};
constexpr BestPlacementPolicy best_placement_policy;

/// Placement as (translation, rotation).
Vector6d as_vector(const MarkerPlacement& placement) {
    return (Vector6d() << placement.translation_m, placement.rotation_rad).finished();
}

Vector6d as_vector(const PlacementBounds& bounds) {
    return (Vector6d() << Eigen::Vector3d::Constant(bounds.translation_m),
            Eigen::Vector3d::Constant(bounds.rotation_rad))
        .finished();
}

}  // namespace

Eigen::Matrix<double, 3, 6> placement_tangent(const MarkerPlacement& placement, const Eigen::Vector3d& x) {
    Eigen::Matrix<double, 3, 6> tangent;
    tangent << Eigen::Matrix3d::Identity(), measurement::d_rotated_d_omega(placement.rotation_rad, x);
    return tangent;
}

MarkerPlacement best_placement(const MarkerTarget& target, const sensitivity::NodeMotion& motion,
                               const PlacementBounds& bounds) {
    if (target.from_start) return target.placement;
    MarkerTarget placed = target;
    placed.placement.translation_m.setZero();
    placed.placement.rotation_rad.setZero();
    const VectorXd times = target.times_s.array() - target.placement.start_shift_s;
    const std::vector<Eigen::Matrix3Xd> markers = measurement::observe(motion, target.markers, times).positions;
    const Vector6d most = as_vector(bounds);
    for (int step = 0; step < best_placement_policy.max_steps; ++step) {
        const std::vector<Eigen::Matrix3Xd> residuals = target_residuals(placed, motion);
        MatrixXd A(target.coordinates(), 6);
        VectorXd r(target.coordinates());
        Index row = 0;
        for (std::size_t m = 0; m < residuals.size(); ++m)
            for (Index t = 0; t < residuals[m].cols(); ++t) {
                const Eigen::Matrix<double, 3, 6> tangent = placement_tangent(placed.placement, markers[m].col(t));
                for (Index axis = 0; axis < 3; ++axis) {
                    if (!std::isfinite(residuals[m](axis, t))) continue;
                    A.row(row) = tangent.row(axis);
                    r(row++) = residuals[m](axis, t);
                }
            }
        // Scaled by the bounds, so that metres and radians are comparable. A zero bound fixes its component.
        const Vector6d here = as_vector(placed.placement);
        const Vector6d unit = most.cwiseMax(1e-300);
        const VectorXd lower = (-most - here).cwiseQuotient(unit), upper = (most - here).cwiseQuotient(unit);
        const VectorXd change = bounded_step(A.topRows(row) * unit.asDiagonal(), r.head(row), lower, upper);
        const Vector6d next = here + unit.cwiseProduct(change);
        placed.placement.translation_m = next.head<3>();
        placed.placement.rotation_rad = next.tail<3>();
        if (change.norm() < best_placement_policy.converged) break;
    }
    return placed.placement;
}

bool at_bound(const MarkerPlacement& placement, const PlacementBounds& bounds) {
    const Vector6d most = as_vector(bounds);
    // A zero bound fixes its component, which is no outcome of the search.
    return (most.array() > 0.0 && as_vector(placement).cwiseAbs().array() >= (1.0 - 1e-9) * most.array()).any();
}

}  // namespace myo::inverse
