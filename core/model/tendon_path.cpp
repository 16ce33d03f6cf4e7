#include "model/tendon_path.hpp"

#include <algorithm>
#include <cmath>

namespace myo::model {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct TendonPathPolicy {
    double smooth_bend_rad = 1e-3;  // b0: a hundredth of the bends that matter
};
constexpr TendonPathPolicy tendon_path_policy;

/// Bend at the guide between legs `leg - 1` and `leg`, smoothed, and its derivative by the difference of their
/// directions.
struct Bend {
    double value;
    Vector3d by_difference;
};
Bend bend_before(const TendonPath& path, std::size_t leg) {
    const double b0 = tendon_path_policy.smooth_bend_rad;
    const Vector3d d = path.direction[leg] - path.direction[leg - 1];
    const double chord = std::min(d.norm(), 2.0 - 1e-9);  // a thread that turns back has no derivative
    // Angle between unit vectors from their chord: more accurate for small angles than from the cosine.
    const double half = std::asin(0.5 * chord), angle = 2.0 * half, root = std::hypot(angle, b0);
    // d(angle) = d . dd / (chord cos(angle / 2)), and angle / chord tends to 1 for a straight thread.
    const double ratio = chord > 1e-8 ? angle / chord : 1.0;
    return {root - b0, ratio / (root * std::cos(half)) * d};
}

}  // namespace

TendonPath tendon_path(const std::vector<Vector3d>& points) {
    TendonPath path;
    path.length.resize(static_cast<Index>(points.size()) - 1);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vector3d leg = points[i + 1] - points[i];
        path.length(static_cast<Index>(i)) = leg.norm();
        path.direction.push_back(leg / leg.norm());
    }
    path.total = path.length.sum();
    return path;
}

VectorXd lengthening(const TendonPath& path, const std::vector<Vector3d>& dp) {
    VectorXd change(path.length.size());
    for (std::size_t leg = 0; leg < path.legs(); ++leg)
        change(static_cast<Index>(leg)) = path.direction[leg].dot(dp[leg + 1] - dp[leg]);
    return change;
}

Matrix3d turning(const TendonPath& path, std::size_t leg) {
    const Vector3d& t = path.direction[leg];
    return (Matrix3d::Identity() - t * t.transpose()) / path.length(static_cast<Index>(leg));
}

std::vector<Vector3d> pulls_on_guides(const TendonPath& path, const VectorXd& tensions) {
    std::vector<Vector3d> pulls(path.legs() + 1, Vector3d::Zero());
    for (std::size_t leg = 0; leg < path.legs(); ++leg) {
        const Vector3d pull = tensions(static_cast<Index>(leg)) * path.direction[leg];
        pulls[leg] -= pull;
        pulls[leg + 1] += pull;
    }
    return pulls;
}

VectorXd capstan_factors(const TendonPath& path, double friction) {
    VectorXd factors = VectorXd::Ones(path.length.size());
    if (friction == 0.0) return factors;
    double passed = 0.0;
    for (std::size_t leg = 1; leg < path.legs(); ++leg) {
        // Tension falls at every guide between the motor and the leg.
        passed += bend_before(path, leg).value;
        factors(static_cast<Index>(leg)) = std::exp(-friction * passed);
    }
    return factors;
}

VectorXd capstan_changes(const TendonPath& path, double friction, const VectorXd& factors,
                         const std::vector<Vector3d>& dp, double friction_change) {
    VectorXd changes = VectorXd::Zero(factors.size());
    double passed = 0.0, passed_change = 0.0;
    for (std::size_t leg = 1; leg < path.legs(); ++leg) {
        const Bend bend = bend_before(path, leg);
        // Change of the difference of the directions of both legs.
        const Vector3d difference = turning(path, leg) * (dp[leg + 1] - dp[leg]) -
                                    turning(path, leg - 1) * (dp[leg] - dp[leg - 1]);
        passed += bend.value;
        passed_change += bend.by_difference.dot(difference);
        changes(static_cast<Index>(leg)) = -factors(static_cast<Index>(leg)) *
                                           (friction * passed_change + friction_change * passed);
    }
    return changes;
}

void pull_by_capstan(const TendonPath& path, double friction, const VectorXd& factors, const VectorXd& by_factor,
                     std::vector<Vector3d>& by_position) {
    double by_passed = 0.0;  // adjoint of the bends up to a leg: they act on all legs beyond
    for (std::size_t leg = path.legs() - 1; leg >= 1; --leg) {
        // From the anchor to the motor: a bend changes the tension of all legs behind it.
        by_passed -= friction * factors(static_cast<Index>(leg)) * by_factor(static_cast<Index>(leg));
        const Vector3d by_difference = by_passed * bend_before(path, leg).by_difference;
        const Vector3d after = turning(path, leg) * by_difference, before = turning(path, leg - 1) * by_difference;
        by_position[leg + 1] += after;
        by_position[leg] -= after + before;
        by_position[leg - 1] += before;
    }
}

}  // namespace myo::model
