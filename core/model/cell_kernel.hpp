#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "fem/element_block.hpp"
#include "material/material.hpp"
#include "model/hourglass.hpp"
#include "model/model.hpp"

namespace myo {

/// What a cell's energy is evaluated with. Pointers may be null: that part is left out.
struct CellInput {
    const Material* material = nullptr;
    const Moduli* elastic = nullptr;
    const Moduli* viscous = nullptr;    // damping times moduli [Pa s]; needs `rate_history`
    double rate_factor = 0.0;               // strain rate = rate_factor * strain + rate_history
    const double* rate_history = nullptr;   // strains_per_cell entries
    const double* pressure = nullptr;       // per volume point: pressure of the geometric stiffness; null = the current one
};

template <int N>
struct CellOutput {
    double energy = 0.0;
    Eigen::Matrix<double, 3, N> gradient;          // dW/dx
    Eigen::Matrix<double, 3 * N, 3 * N> hessian;   // unknowns in node order; untouched unless asked for
};

/// Green strain (xx, yy, zz, xy, yz, zx).
inline Eigen::Matrix<double, 6, 1> green_strain(const Eigen::Matrix3d& F) {
    const Eigen::Matrix3d E = 0.5 * (F.transpose() * F - Eigen::Matrix3d::Identity());
    return (Eigen::Matrix<double, 6, 1>() << E(0, 0), E(1, 1), E(2, 2), E(0, 1), E(1, 2), E(2, 0)).finished();
}

/// The trace-free part of a symmetric tensor given as (xx, yy, zz, xy, yz, zx).
inline Eigen::Matrix3d deviator(const Eigen::Matrix<double, 6, 1>& e) {
    const double mean = (e(0) + e(1) + e(2)) / 3.0;
    Eigen::Matrix3d D;
    D << e(0) - mean, e(3), e(5), e(3), e(1) - mean, e(4), e(5), e(4), e(2) - mean;
    return D;
}

/// Adds weight * G A G' block by block: the pull-back of a 9 x 9 tangent to the nodes. A is symmetric.
template <int N>
void add_pulled_back(const Matrix9d& A, const Eigen::Matrix<double, N, 3>& G, double weight,
                     Eigen::Matrix<double, 3 * N, 3 * N>& K) {
    using Strided = Eigen::Map<Eigen::Matrix<double, N, N>, 0, Eigen::Stride<9 * N, 3>>;
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i <= k; ++i) {
            Eigen::Matrix3d Aik;
            for (int l = 0; l < 3; ++l)
                for (int j = 0; j < 3; ++j) Aik(j, l) = A(i + 3 * j, k + 3 * l);
            const Eigen::Matrix<double, N, N> block = weight * (G * Aik) * G.transpose();
            Strided(&K(i, k)).noalias() += block;
            if (i != k) Strided(&K(k, i)).noalias() += block.transpose();
        }
}

/// Kelvin-Voigt response of one point: potential mu_v / rate_factor |dev Edot|^2, Edot = rate_factor E(F) + history.
/// Its gradient is F S with S = 2 mu_v dev Edot, the schema's second Piola stress, and its Hessian is symmetric: a strain
/// rate differenced like the velocity keeps every step a minimisation.
template <bool WithHessian>
TensorFunction viscous_response(const Eigen::Matrix3d& F, double mu_v, double rate_factor, const double* history) {
    const Eigen::Matrix<double, 6, 1> rate =
        rate_factor * green_strain(F) + Eigen::Map<const Eigen::Matrix<double, 6, 1>>(history);
    const Eigen::Matrix3d dev = deviator(rate);
    const Eigen::Matrix3d S = 2.0 * mu_v * dev;
    TensorFunction W;
    W.value = rate_factor > 0.0 ? mu_v / rate_factor * dev.squaredNorm() : 0.0;
    W.gradient = F * S;
    if constexpr (WithHessian) {
        const Eigen::Matrix3d B = F * F.transpose();
        const double scale = 2.0 * mu_v * rate_factor;
        for (int l = 0; l < 3; ++l)
            for (int k = 0; k < 3; ++k)
                for (int j = 0; j < 3; ++j)
                    for (int i = 0; i < 3; ++i)
                        W.hessian(i + 3 * j, k + 3 * l) =
                            (i == k ? S(j, l) : 0.0) +
                            scale * (0.5 * ((j == l ? B(i, k) : 0.0) + F(i, l) * F(k, j)) - F(i, j) * F(k, l) / 3.0);
    }
    return W;
}

/// Hourglass strains h = F^-1 x gamma and the map dh = F^-1 dx Gamma'.
struct HourglassStrain {
    Eigen::Matrix3d F_inverse;
    Matrix34d strain;
    Eigen::Matrix<double, 8, 4> Gamma;
};

inline HourglassStrain hourglass_strain(const Eigen::Matrix<double, 3, 8>& x, const Eigen::Matrix<double, 8, 3>& G,
                                        const HourglassGeometry& geometry) {
    HourglassStrain h;
    h.F_inverse = (x * G).inverse();
    h.strain = h.F_inverse * (x * geometry.gamma);
    h.Gamma = geometry.gamma - G * h.strain;
    return h;
}

template <bool WithHessian>
void add_hourglass(const Eigen::Matrix<double, 3, 8>& x, const Eigen::Matrix<double, 8, 3>& G, const HourglassGeometry& geometry,
                   double volume, const CellInput& in, const double* history, CellOutput<8>& out) {
    using Vector12d = Eigen::Matrix<double, 12, 1>;
    const HourglassStrain h = hourglass_strain(x, G, geometry);
    const Eigen::Map<const Vector12d> strain(h.strain.data());
    Vector12d stress = Vector12d::Zero();
    Matrix12d K = Matrix12d::Zero();
    if (in.elastic) {
        K = hourglass_stiffness(geometry, volume, in.elastic->mu);
        stress = K * strain;
        out.energy += 0.5 * strain.dot(stress);
    }
    if (in.viscous) {
        const Matrix12d Kv = hourglass_stiffness(geometry, volume, in.viscous->mu);
        const Vector12d rate = in.rate_factor * strain + Eigen::Map<const Vector12d>(history);
        const Vector12d viscous = Kv * rate;
        if (in.rate_factor > 0.0) out.energy += 0.5 / in.rate_factor * rate.dot(viscous);
        stress += viscous;
        K += in.rate_factor * Kv;
    }
    const Matrix34d T = h.F_inverse.transpose() * Eigen::Map<const Matrix34d>(stress.data());
    const Eigen::Matrix<double, 3, 8> f = T * h.Gamma.transpose();
    out.gradient += f;
    if constexpr (WithHessian) {
        // dh = F^-1 dx Gamma', so each pair of shapes contributes F^-T K_st F^-1, spread over the nodes by Gamma.
        Eigen::Matrix<double, 24, 12> spread = Eigen::Matrix<double, 24, 12>::Zero();
        for (int t = 0; t < 4; ++t)
            for (int s = 0; s < 4; ++s) {
                const Eigen::Matrix3d block = h.F_inverse.transpose() * K.block<3, 3>(3 * s, 3 * t) * h.F_inverse;
                for (int node = 0; node < 8; ++node) spread.block<3, 3>(3 * node, 3 * t) += h.Gamma(node, s) * block;
            }
        for (int b = 0; b < 8; ++b)
            for (int t = 0; t < 4; ++t) out.hessian.middleCols<3>(3 * b) += h.Gamma(b, t) * spread.middleCols<3>(3 * t);
        const Eigen::Matrix<double, 8, 3> GF = G * h.F_inverse;
        for (int b = 0; b < 8; ++b)
            for (int a = 0; a < 8; ++a)
                out.hessian.block<3, 3>(3 * a, 3 * b) -= f.col(b) * GF.row(a) + GF.row(b).transpose() * f.col(a).transpose();
    }
}

/// Energy, gradient and, if asked for, Hessian of one cell at the positions x.
template <bool WithHessian, int N, int Q>
void evaluate_cell(const ElementBlock<N, Q>& block, int cell, const Eigen::Matrix<double, 3, N>& x, const CellInput& in,
                   CellOutput<N>& out) {
    const CellGeometry<N, Q>& geometry = block.geometry[static_cast<std::size_t>(cell)];
    out.energy = 0.0;
    out.gradient.setZero();
    if constexpr (WithHessian) out.hessian.setZero();
    double mean_theta = 0.0;
    Eigen::Matrix<double, 3, N> mean_gradient = Eigen::Matrix<double, 3, N>::Zero();
    std::array<Matrix9d, Q> theta_hessian;

    for (std::size_t q = 0; q < Q; ++q) {
        const Eigen::Matrix<double, N, 3>& G = geometry.gradient[q];
        const double weight = geometry.weight[q];
        const Eigen::Matrix3d F = x * G;
        Eigen::Matrix3d P = Eigen::Matrix3d::Zero();
        Matrix9d A;
        if constexpr (WithHessian) A.setZero();
        if (in.elastic) {
            const double mu = in.elastic->mu, kappa = in.elastic->kappa;
            const TensorFunction W = in.material->distortion(F, mu, kappa, WithHessian);
            const TensorFunction theta = in.material->volume_measure(F, WithHessian);
            out.energy += weight * W.value;
            P += W.gradient;
            if constexpr (WithHessian) A += W.hessian;
            if (block.mean_volume) {
                mean_theta += weight / geometry.volume * theta.value;
                mean_gradient += weight * theta.gradient * G.transpose();
                if constexpr (WithHessian) theta_hessian[q] = theta.hessian;
            }
            const double point_kappa = block.mean_volume ? block.point_bulk_over_mu * mu : kappa;
            if (point_kappa != 0.0) {
                const ScalarFunction U = in.material->bulk(theta.value, point_kappa);
                out.energy += weight * U.value;
                P += U.first * theta.gradient;
                if constexpr (WithHessian) {
                    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> g(theta.gradient.data());
                    A += U.second * g * g.transpose() + (in.pressure && !block.mean_volume ? in.pressure[q] : U.first) * theta.hessian;
                }
            }
        }
        if (in.viscous) {
            const TensorFunction D =
                viscous_response<WithHessian>(F, in.viscous->mu, in.rate_factor, in.rate_history + 6 * q);
            out.energy += weight * D.value;
            P += D.gradient;
            if constexpr (WithHessian) A += D.hessian;
        }
        out.gradient.noalias() += weight * P * G.transpose();
        if constexpr (WithHessian) add_pulled_back<N>(A, G, weight, out.hessian);
    }

    if (block.mean_volume && in.elastic) {
        const ScalarFunction U = in.material->bulk(mean_theta, in.elastic->kappa - block.point_bulk_over_mu * in.elastic->mu);
        out.energy += geometry.volume * U.value;
        out.gradient += U.first * mean_gradient;
        if constexpr (WithHessian) {
            const double p = in.pressure ? *in.pressure : U.first;
            for (std::size_t q = 0; q < Q; ++q) add_pulled_back<N>(theta_hessian[q], geometry.gradient[q], p * geometry.weight[q], out.hessian);
            const Eigen::Map<const Eigen::Matrix<double, 3 * N, 1>> g(mean_gradient.data());
            out.hessian.noalias() += U.second / geometry.volume * g * g.transpose();
        }
    }
    if constexpr (N == 8 && Q == 1)
        if (!block.hourglass.empty())
            add_hourglass<WithHessian>(x, geometry.gradient[0], block.hourglass[static_cast<std::size_t>(cell)], geometry.volume, in,
                                       in.rate_history ? in.rate_history + 6 : nullptr, out);
}

}  // namespace myo
