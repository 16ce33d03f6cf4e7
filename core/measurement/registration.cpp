#include "measurement/registration.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cassert>
#include <cmath>
#include <string>

namespace myo {
namespace {

// Below this ratio of width to length the turn about the line is noise.
constexpr double line_ratio = 1e-4;

bool on_a_line(const Eigen::Matrix3Xd& centred, const Eigen::VectorXd& weights) {
    const Eigen::Matrix3Xd scaled = centred * weights.cwiseSqrt().asDiagonal();
    // Singular values of the points themselves: those of their moments would square the ratio into rounding.
    const Eigen::Vector3d extents = Eigen::JacobiSVD<Eigen::Matrix3Xd>(scaled).singularValues().head<3>();
    return !(extents(1) > line_ratio * extents(0));
}

}  // namespace

Result<Registration> rigid_registration(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                                        const Eigen::VectorXd& weights) {
    assert(from.cols() == to.cols() && (weights.size() == 0 || weights.size() == from.cols()));
    const Eigen::Index n = from.cols();
    Eigen::VectorXd w = weights.size() == 0 ? Eigen::VectorXd(Eigen::VectorXd::Ones(n)) : weights;
    if (!from.allFinite() || !to.allFinite() || !w.allFinite() || (w.array() < 0.0).any()) {
        return Error{"rigid registration needs finite positions and weights that are not negative", ""};
    }
    const Eigen::Index used = (w.array() > 0.0).count();
    if (used < 3) return Error{"rigid registration needs at least 3 points, got " + std::to_string(used), ""};
    w /= w.sum();

    const Eigen::Vector3d from_mean = from * w;
    const Eigen::Vector3d to_mean = to * w;
    const Eigen::Matrix3Xd p = from.colwise() - from_mean;
    const Eigen::Matrix3Xd q = to.colwise() - to_mean;
    if (on_a_line(p, w) || on_a_line(q, w)) {
        return Error{"rigid registration is not determined: all points lie on one line, so the turn about it is free", ""};
    }
    const Eigen::Matrix3d moments = q * w.asDiagonal() * p.transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0) signs(2) = -1.0;  // no mirror image

    Registration result;
    result.motion.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    result.motion.translation = to_mean - result.motion.rotation * from_mean;
    result.residual_m = result.motion.rotation * p - q;
    result.distance_m = result.residual_m.colwise().norm();
    result.rms_m = std::sqrt(w.dot(result.distance_m.cwiseAbs2()));
    return result;
}

}  // namespace myo
