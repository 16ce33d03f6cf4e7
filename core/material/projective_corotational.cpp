#include <Eigen/LU>

#include <array>
#include <cmath>
#include <limits>

#include "material/catalogue.hpp"
#include "material/lanes.hpp"
#include "material/polar.hpp"
#include "material/tensors.hpp"

namespace myo::material {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Point d with d0 d1 d2 = 1 nearest to sigma, with the derivative dd/dsigma. Newton's method on d = sigma - p cof(d).
struct UnitVolumeProjection {
    Vector3d d;
    Matrix3d derivative;
    bool found = false;
};

/// Initial value of Newton's method. At the solution d_i (d_i - sigma_i) = -p, so a compressed or inverted sigma has a
/// single p < 0 with positive d_i that grow with -p: bisection over decades. Far from unit volume, Newton's method from
/// d = 1 may stay in a wrong octant.
void start_of_projection(const Vector3d& sigma, Vector3d& d, double& p) {
    d.setOnes();
    p = 0.0;
    if (sigma.minCoeff() > 0.5 || sigma.cwiseMax(0.0).prod() >= 1.0) return;
    const auto at = [&](double q) -> Vector3d {
        // Positive root, without cancellation for negative sigma.
        const Eigen::Array3d root = (sigma.array().square() + 4.0 * q).sqrt();
        return (sigma.array() >= 0.0).select(0.5 * (sigma.array() + root), 2.0 * q / (root - sigma.array()));
    };
    double low = 1e-30, high = 1.0 + 4.0 * sigma.squaredNorm();  // d_i > 1 for all i there
    for (int halving = 0; halving < 20; ++halving) {
        const double middle = std::sqrt(low * high);
        (at(middle).prod() < 1.0 ? low : high) = middle;
    }
    p = -high;
    d = at(high);
}

/// Cofactors of diag(d).
Vector3d cofactors(const Vector3d& d) { return {d(1) * d(2), d(2) * d(0), d(0) * d(1)}; }

UnitVolumeProjection project_to_unit_volume(const Vector3d& sigma) {
    UnitVolumeProjection result;
    Vector3d d;
    double p;
    start_of_projection(sigma, d, p);
    Eigen::Matrix4d system;
    for (int iteration = 0; iteration < 60; ++iteration) {
        const Vector3d c = cofactors(d);
        Eigen::Vector4d residual;
        residual << d - sigma + p * c, d.prod() - 1.0;
        system.setZero();
        system.diagonal().head<3>().setOnes();
        system(0, 1) = system(1, 0) = p * d(2);
        system(1, 2) = system(2, 1) = p * d(0);
        system(0, 2) = system(2, 0) = p * d(1);
        system.col(3).head<3>() = c;
        system.row(3).head<3>() = c.transpose();
        const Eigen::Matrix4d inverse = system.inverse();
        if (residual.norm() < 1e-14 * (1.0 + sigma.norm())) {
            result.d = d;
            // Implicit differentiation: the system is the derivative of the equations by (d, p).
            result.derivative = inverse.topLeftCorner<3, 3>();
            result.found = true;
            return result;
        }
        Eigen::Vector4d step = inverse * residual;
        // Damping: a full step may leave the positive octant and converge to another branch.
        double length = 1.0;
        while (length > 1e-6 && ((d - length * step.head<3>()).array() <= 0.1 * d.array()).any()) length *= 0.5;
        d -= length * step.head<3>();
        p -= length * step(3);
    }
    return result;
}

/// Energy of the paper, mu |F - R|^2 + lambda/2 |F - D|^2 with D the nearest matrix of det D = 1.
///
/// For small strain the second term is lambda/6 tr(eps)^2: the published lambda acts as a third of Lamé's. There is no
/// separate volume measure that elements could average, so the law locks, as published.
/// Source: Bouaziz et al. 2014; Dubied et al. 2022, sec. III.
class ProjectiveCorotational final : public MaterialOf<ProjectiveCorotational> {
public:
    std::string id() const override { return "projective_corotational"; }
    std::string label() const override { return "Projective corotational (as published)"; }
    std::string formula() const override { return "μ |F − R|² + λ/2 |F − D|², det D = 1"; }
    std::string explanation() const override {
        return "μ = E / (2 (1 + ν)), λ = E ν / ((1 + ν) (1 − 2ν)), F = R U with the rotation R, D the matrix nearest "
               "to F "
               "whose determinant is 1 (Bouaziz et al. 2014).";
    }

    bool has_split() const override { return false; }

    static void respond_at(const Matrix3d& F, const double& mu, const double& kappa, bool with_hessian,
                           LawResponse<double>& out) {
        const double lambda = kappa - 2.0 / 3.0 * mu;
        const SignedSvd svd = signed_svd(F);
        const UnitVolumeProjection projection = project_to_unit_volume(svd.sigma);
        TensorFunction& W = out.distortion;
        if (!projection.found) {
            W.value = out.volume.value = std::numeric_limits<double>::quiet_NaN();
            W.gradient.setConstant(W.value);
            out.volume.gradient.setConstant(W.value);
            W.hessian.setConstant(W.value);
            return;
        }
        const Vector3d shear = svd.sigma - Vector3d::Ones();
        const Vector3d volume = svd.sigma - projection.d;
        const Vector3d psi = 2.0 * mu * shear + lambda * volume;  // dW/dsigma, by the envelope theorem
        W.value = mu * shear.squaredNorm() + lambda / 2.0 * volume.squaredNorm();
        W.gradient = svd.U * psi.asDiagonal() * svd.V.transpose();
        out.volume.value = 0.5 * volume.squaredNorm();
        out.volume.gradient = svd.U * volume.asDiagonal() * svd.V.transpose();
        if (with_hessian) {
            const Matrix3d psi2 = 2.0 * mu * Matrix3d::Identity() +
                                  lambda * (Matrix3d::Identity() - projection.derivative);
            W.hessian = isotropic_hessian(svd, psi, psi2, 2.0 * mu + lambda, lambda, projection.d);
        }
    }

    /// Computes D without singular values: fixed-point iteration on D = F - p cof D, det D = 1. Near unit volume its
    /// convergence rate is about p. Lanes that do not converge use the principal values.
    static void respond_at(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, bool with_hessian,
                           LawResponse<Pack>& out) {
        const Pack lambda = kappa - Pack(2.0 / 3.0) * mu;
        const Matrix3<Pack> R = polar_rotation(F);
        Matrix3<Pack> D = F, C;
        Pack p = 0.0;
        PackMask open(true);
        for (int iteration = 0; iteration < 12 && std::experimental::any_of(open); ++iteration) {
            C = cofactor(D);
            const Pack J = D(0, 0) * C(0, 0) + D(1, 0) * C(1, 0) + D(2, 0) * C(2, 0);
            p += (J - Pack(1.0)) / double_dot(C, C);
            Pack change = 0.0;
            for (int k = 0; k < 9; ++k) {
                Pack& entry = D(k % 3, k / 3);
                const Pack next = F(k % 3, k / 3) - p * C(k % 3, k / 3);
                change += (next - entry) * (next - entry);
                entry = next;
            }
            open = !(change * p * p < 1e-30 && change < 1e-12);  // the next change is about p times this one
        }
        open = open || !(std::experimental::abs(p) < 0.3);  // farther away another branch may be nearer
        const Matrix3<Pack> shear = F - R, volume = F - D;
        out.distortion.value = mu * double_dot(shear, shear) + Pack(0.5) * lambda * double_dot(volume, volume);
        out.distortion.gradient = shear * (Pack(2.0) * mu) + volume * lambda;
        out.volume.value = Pack(0.5) * double_dot(volume, volume);
        out.volume.gradient = volume;
        if (with_hessian) {
            const Matrix9<Pack> dR = polar_rotation_derivative(F, R), dD = unit_volume_derivative(D, p);
            const Pack identity = Pack(2.0) * mu + lambda;
            for (int column = 0; column < 9; ++column)
                for (int row = 0; row < 9; ++row) {
                    Pack& entry = out.distortion.hessian(row, column);
                    entry = -(Pack(2.0) * mu * dR(row, column) + lambda * dD(row, column));
                    if (row == column) entry += identity;
                }
        }
        for (int lane = 0; lane < pack_width; ++lane)
            if (const auto l = static_cast<std::size_t>(lane); open[l]) {
                LawResponse<double> single;
                respond_at(Matrix3d(lane_of(F, lane)), static_cast<double>(mu[l]), static_cast<double>(kappa[l]),
                           with_hessian, single);
                set_lane(out.distortion, lane, single.distortion, with_hessian);
                set_lane(out.volume, lane, single.volume, false);
            }
    }

    template <class T>
    static ScalarFunctionOf<T> bulk_at(const T&, const T&) {
        return {};
    }

private:
    /// dD/dF from (I + p dcof/dD) dD + cof D dp = dF and cof D : dD = 0 (implicit differentiation with a constraint).
    static Matrix9<Pack> unit_volume_derivative(const Matrix3<Pack>& D, const Pack& p) {
        Matrix9<Pack> K;  // (I + p dcof/dD)^-1 by Gauss-Jordan elimination without pivoting: close to the identity
        for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
            K(row, column) = row == column ? 1.0 : 0.0;
            if (i == k || j == l) return;
            const double sign = ((k - i + 3) % 3 == (l - j + 3) % 3) ? 1.0 : -1.0;
            K(row, column) += sign * p * D(3 - i - k, 3 - j - l);
        });
        for (int pivot = 0; pivot < 9; ++pivot) {
            // The matrix is symmetric, so only the lower triangle is stored. Completed rows have the opposite sign
            // (sweep operator).
            const auto at = [&](int i, int j) -> Pack& { return i >= j ? K(i, j) : K(j, i); };
            const Pack inverse = 1.0 / K(pivot, pivot);
            for (int column = 0; column < 9; ++column) {
                if (column == pivot) continue;
                const Pack factor = at(column, pivot) * inverse;
                for (int row = column; row < 9; ++row)
                    if (row != pivot) K(row, column) -= factor * at(row, pivot);
            }
            for (int i = 0; i < 9; ++i)
                if (i != pivot) at(i, pivot) *= inverse;
            K(pivot, pivot) = -inverse;
        }
        for (int column = 0; column < 9; ++column)
            for (int row = column; row < 9; ++row) K(row, column) = K(column, row) = -K(row, column);
        // Eliminating dp projects K on the tangent space of det D = 1: K - K C C' K / (C' K C).
        const Matrix3<Pack> C = cofactor(D);
        std::array<Pack, 9> KC;
        Pack CKC = 0.0;
        for (int row = 0; row < 9; ++row) {
            Pack& sum = KC[static_cast<std::size_t>(row)];
            sum = 0.0;
            for (int column = 0; column < 9; ++column) sum += K(row, column) * C(column % 3, column / 3);
            CKC += C(row % 3, row / 3) * sum;
        }
        for (int column = 0; column < 9; ++column)
            for (int row = 0; row < 9; ++row)
                K(row, column) -= KC[static_cast<std::size_t>(row)] * KC[static_cast<std::size_t>(column)] / CKC;
        return K;
    }

    /// Hessian of an isotropic energy from its principal derivatives (Smith, De Goes & Kim 2019, "Analytic
    /// eigensystems").
    ///
    /// (psi_i - psi_j)/(sigma_i - sigma_j) is evaluated without cancellation: psi = a sigma - 2 mu - lambda d gives a -
    /// lambda (d_i - d_j)/(sigma_i - sigma_j), and d_i - d_j = (sigma_i - sigma_j)/(1 - p d_k).
    static Matrix9d isotropic_hessian(const SignedSvd& svd, const Vector3d& psi, const Matrix3d& psi2, double a,
                                      double lambda, const Vector3d& d) {
        Matrix9d H = Matrix9d::Zero();
        const auto outer = [&](int i, int j) {
            Eigen::Matrix<double, 9, 1> q;
            for (int col = 0; col < 3; ++col)
                for (int row = 0; row < 3; ++row) q(row + 3 * col) = svd.U(row, i) * svd.V(col, j);
            return q;
        };
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) H += psi2(i, j) * outer(i, i) * outer(j, j).transpose();
        // p from d = sigma - p cof(d), in the sense of least squares.
        const Vector3d cofactor = cofactors(d);
        const double p = cofactor.dot(svd.sigma - d) / cofactor.squaredNorm();
        for (const auto& [i, j, k] : {std::array<int, 3>{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}) {
            const double difference = a - lambda / (1.0 - p * d(k));
            // Symmetric pairs stretch along the diagonals of the plane i, j; skew pairs turn it.
            const double sum = (psi(i) + psi(j)) / (svd.sigma(i) + svd.sigma(j));
            const Eigen::Matrix<double, 9, 1> symmetric = (outer(i, j) + outer(j, i)) / std::sqrt(2.0);
            const Eigen::Matrix<double, 9, 1> skew = (outer(i, j) - outer(j, i)) / std::sqrt(2.0);
            H += difference * symmetric * symmetric.transpose() + sum * skew * skew.transpose();
        }
        return H;
    }
};

}  // namespace

MaterialPointer projective_corotational() { return std::make_shared<ProjectiveCorotational>(); }

}  // namespace myo::material
