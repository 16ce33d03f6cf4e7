#include "material/polar.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace myo {

using Eigen::Matrix3d;
using Eigen::Vector3d;

SignedSvd signed_svd(const Matrix3d& F) {
    const Eigen::JacobiSVD<Matrix3d> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    SignedSvd result{svd.matrixU(), svd.singularValues(), svd.matrixV()};
    if (result.U.determinant() < 0.0) {
        result.U.col(2) *= -1.0;
        result.sigma(2) *= -1.0;
    }
    if (result.V.determinant() < 0.0) {
        result.V.col(2) *= -1.0;
        result.sigma(2) *= -1.0;
    }
    return result;
}

Matrix3d polar_rotation(const Matrix3d& F) {
    const SignedSvd svd = signed_svd(F);
    return svd.U * svd.V.transpose();
}

Matrix9d polar_rotation_derivative(const Matrix3d& F, const Matrix3d& R) {
    const Matrix3d S = R.transpose() * F;
    const Matrix3d A = (S.trace() * Matrix3d::Identity() - 0.5 * (S + S.transpose())).inverse();
    Matrix9d dR;
    for (int l = 0; l < 3; ++l)
        for (int k = 0; k < 3; ++k) {
            // R'dF for dF = e_k e_l' has the row k of R in column l.
            Matrix3d W = Matrix3d::Zero();
            W.col(l) = R.row(k).transpose();
            const Matrix3d skew = W - W.transpose();
            const Vector3d w = A * Vector3d(skew(2, 1), skew(0, 2), skew(1, 0));
            Matrix3d cross;
            cross << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0;
            const Matrix3d column = R * cross;
            dR.col(k + 3 * l) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(column.data());
        }
    return dR;
}

}  // namespace myo
