#include "measurement/registration.hpp"

#include <Eigen/LU>

#include <cassert>
#include <cmath>
#include <string>

#include "material/polar.hpp"

namespace myo::measurement {
namespace {

struct RegistrationPolicy {
    /// Below this ratio of width to length the rotation about the line is determined by noise.
    double line_ratio = 1e-4;
};
constexpr RegistrationPolicy registration_policy;

/// Whether centred points are collinear, by the second-largest extent.
bool on_a_line(const Eigen::Matrix3Xd& centred, const Eigen::VectorXd& weights) {
    const Eigen::Matrix3Xd scaled = centred * weights.cwiseSqrt().asDiagonal();
    // Eigenvalues of the second moments are squared extents.
    const Eigen::Vector3d squares = material::signed_svd(scaled * scaled.transpose()).sigma;
    return !(squares(1) > registration_policy.line_ratio * registration_policy.line_ratio * squares(0));
}

Result<void> check_points(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, const Eigen::VectorXd& w) {
    if (!from.allFinite() || !to.allFinite() || !w.allFinite() || (w.array() < 0.0).any()) {
        return Error{"rigid registration needs finite positions and weights that are not negative", ""};
    }
    const Eigen::Index used = (w.array() > 0.0).count();
    if (used < 3) return Error{"rigid registration needs at least 3 points, got " + std::to_string(used), ""};
    return {};
}

}  // namespace

Result<Registration> rigid_registration(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                                        const Eigen::VectorXd& weights) {
    assert(from.cols() == to.cols() && (weights.size() == 0 || weights.size() == from.cols()));
    const Eigen::Index n = from.cols();
    Eigen::VectorXd w = weights.size() == 0 ? Eigen::VectorXd(Eigen::VectorXd::Ones(n)) : weights;
    if (const Result<void> enough = check_points(from, to, w); !enough) return enough.error();
    // Normalised weights: sums below are weighted means.
    w /= w.sum();

    const Eigen::Vector3d from_mean = from * w;
    const Eigen::Vector3d to_mean = to * w;
    const Eigen::Matrix3Xd p = from.colwise() - from_mean;
    const Eigen::Matrix3Xd q = to.colwise() - to_mean;
    if (on_a_line(p, w) || on_a_line(q, w)) {
        return Error{"rigid registration is not determined: all points lie on one line, so the turn about it is free",
                     ""};
    }
    // The optimal rotation is the polar factor of the cross-covariance; see the sources in the header.
    const Eigen::Matrix3d moments = q * w.asDiagonal() * p.transpose();

    Registration result;
    result.motion.rotation = material::polar_rotation(moments);  // proper rotation: no reflection
    result.motion.translation = to_mean - result.motion.rotation * from_mean;
    result.residual_m = result.motion.rotation * p - q;
    result.distance_m = result.residual_m.colwise().norm();
    result.rms_m = std::sqrt(w.dot(result.distance_m.cwiseAbs2()));
    return result;
}

// Minimises sum w |translation + rotation x to - displacement|^2.
Eigen::MatrixXd d_registration_d_to(const Eigen::Matrix3Xd& to, const Eigen::VectorXd& weights) {
    assert(weights.size() == to.cols());
    Eigen::MatrixXd motion(3 * to.cols(), 6);
    for (Eigen::Index i = 0; i < to.cols(); ++i)
        motion.middleRows<3>(3 * i) << Eigen::Matrix3d::Identity(), -cross_matrix(Eigen::Vector3d(to.col(i)));
    const Eigen::MatrixXd weighted = weights.transpose().replicate(3, 1).reshaped().asDiagonal() * motion;
    return (motion.transpose() * weighted).fullPivLu().solve(weighted.transpose());
}

}  // namespace myo::measurement
