#include "material/polar.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include "material/lanes.hpp"
#include "material/tensors.hpp"

namespace myo::material {
namespace {

using Eigen::Matrix3d;

/// Closed-form derivative of the polar rotation for both scalar types.
template <class T>
Matrix9<T> rotation_derivative(const Matrix3<T>& F, const Matrix3<T>& R) {
    Matrix3<T> S;  // symmetric part of R'F
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            T sum = T(0.0);
            for (int k = 0; k < 3; ++k) sum += R(k, i) * F(k, j) + R(k, j) * F(k, i);
            S(i, j) = T(0.5) * sum;
        }
    const T trace = S(0, 0) + S(1, 1) + S(2, 2);
    Matrix3<T> A = -S;
    for (int i = 0; i < 3; ++i) A(i, i) += trace;
    const Matrix3<T> C = cofactor(A);  // A is symmetric: A^-1 = C / det A
    const T inverse_determinant = T(1.0) / (A(0, 0) * C(0, 0) + A(1, 0) * C(1, 0) + A(2, 0) * C(2, 0));
    Matrix9<T> dR;
    for (int l = 0; l < 3; ++l)
        for (int k = 0; k < 3; ++k) {
            // R'dF for dF = e_k e_l' has row k of R in column l. Its axial vector is e_l x (that row).
            const int next = (l + 1) % 3, last = (l + 2) % 3;
            T w[3];
            for (int i = 0; i < 3; ++i)
                w[i] = inverse_determinant * (C(i, last) * R(k, next) - C(i, next) * R(k, last));
            for (int i = 0; i < 3; ++i) {
                dR(i, k + 3 * l) = R(i, 1) * w[2] - R(i, 2) * w[1];
                dR(i + 3, k + 3 * l) = R(i, 2) * w[0] - R(i, 0) * w[2];
                dR(i + 6, k + 3 * l) = R(i, 0) * w[1] - R(i, 1) * w[0];
            }
        }
    return dR;
}

}  // namespace

SignedSvd signed_svd(const Matrix3d& F) {
    const Eigen::JacobiSVD<Matrix3d> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
    SignedSvd result{svd.matrixU(), svd.singularValues(), svd.matrixV()};
    // Reflections are moved from U and V into the sign of the smallest singular value.
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

Matrix3<Pack> polar_rotation(const Matrix3<Pack>& F) {
    using std::experimental::any_of;
    Matrix3<Pack> R = F;
    PackMask open(true);
    for (int iteration = 0; iteration < 12 && any_of(open); ++iteration) {
        const Matrix3<Pack> C = cofactor(R);
        // Newton's iteration R <- (R + R^-T) / 2 with R^-T = cof R / J.
        const Pack J = R(0, 0) * C(0, 0) + R(1, 0) * C(1, 0) + R(2, 0) * C(2, 0);
        if (iteration == 0 && any_of(!(J > 0.05))) break;  // near-singular lanes need more iterations than allowed here
        const Pack half = Pack(0.5), cofactor_part = half / J;
        Pack change = 0.0;
        for (int k = 0; k < 9; ++k) {
            Pack& entry = R(k % 3, k / 3);
            const Pack next = half * entry + cofactor_part * C(k % 3, k / 3);
            change += (next - entry) * (next - entry);
            entry = next;
        }
        open = !(change < 1e-15);  // quadratic convergence: after a change of 3e-8 the error is below rounding
    }
    // Lanes that have not converged; all of them if one was near singular.
    if (any_of(open))
        for (int lane = 0; lane < pack_width; ++lane)
            if (open[static_cast<std::size_t>(lane)]) set_lane(R, lane, polar_rotation(Matrix3d(lane_of(F, lane))));
    return R;
}

Matrix9<double> polar_rotation_derivative(const Matrix3d& F, const Matrix3d& R) { return rotation_derivative(F, R); }
Matrix9<Pack> polar_rotation_derivative(const Matrix3<Pack>& F, const Matrix3<Pack>& R) {
    return rotation_derivative(F, R);
}

}  // namespace myo::material
