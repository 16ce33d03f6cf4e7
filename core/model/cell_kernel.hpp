#pragma once

#include <Eigen/Core>

#include "base/pack.hpp"
#include "material/material.hpp"
#include "material/tensors.hpp"
#include "model/hourglass.hpp"
#include "model/packed_cells.hpp"
#include "model/point_bulk.hpp"

namespace myo {

/// What the energy of a pack of cells is evaluated with. Pointers may be null: that part is left out.
struct PackInput {
    const Material* material = nullptr;
    bool elastic = false, viscous = false;
    Pack mu = 0.0, kappa = 0.0;             // [Pa]
    PointBulk point_bulk;                   // of cells with a mean volume
    Pack viscous_mu = 0.0;                  // damping times mu [Pa s]; needs `rate_history`
    double rate_factor = 0.0;               // strain rate = rate_factor * strain + rate_history
    const double* rate_history = nullptr;   // strains_per_cell packs
    const double* pressure = nullptr;       // volumes_per_cell packs: pressure of the geometric stiffness; null = the current one
};

/// Number of the block (a, b), a >= b, of a cell's symmetric matrix: column by column of the lower triangle.
template <int N>
constexpr int lower_block(int a, int b) {
    return b * N - b * (b - 1) / 2 + a - b;
}

template <int N>
struct PackOutput {
    Pack energy;
    Eigen::Matrix<Pack, 3, N> gradient;                      // dW/dx
    std::array<Matrix3<Pack>, N*(N + 1) / 2> hessian;        // 3 x 3 blocks, see lower_block; untouched unless asked for
};

/// Offset of an entry of a per-cell field within its pack's part.
inline const double* entry(const double* field, int i) { return field + i * pack_width; }

/// Small products, written out: packs have no matrix kernels.
template <int N>
Matrix3<Pack> deformation_gradient(const Eigen::Matrix<Pack, 3, N>& x, const Eigen::Matrix<Pack, N, 3>& G) {
    Matrix3<Pack> F;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            Pack sum = x(i, 0) * G(0, j);
            for (int a = 1; a < N; ++a) sum += x(i, a) * G(a, j);
            F(i, j) = sum;
        }
    return F;
}

/// gradient += P G'.
template <int N>
void add_nodal_forces(const Matrix3<Pack>& P, const Eigen::Matrix<Pack, N, 3>& G, Eigen::Matrix<Pack, 3, N>& gradient) {
    for (int a = 0; a < N; ++a)
        for (int i = 0; i < 3; ++i) gradient(i, a) += P(i, 0) * G(a, 0) + P(i, 1) * G(a, 1) + P(i, 2) * G(a, 2);
}

/// Green strain (xx, yy, zz, xy, yz, zx).
using PackStrain = std::array<Pack, 6>;

inline Pack column_dot(const Matrix3<Pack>& A, int i, const Matrix3<Pack>& B, int j) {
    return A(0, i) * B(0, j) + A(1, i) * B(1, j) + A(2, i) * B(2, j);
}

inline PackStrain green_strain(const Matrix3<Pack>& F) {
    return {0.5 * (column_dot(F, 0, F, 0) - 1.0), 0.5 * (column_dot(F, 1, F, 1) - 1.0), 0.5 * (column_dot(F, 2, F, 2) - 1.0),
            0.5 * column_dot(F, 0, F, 1),         0.5 * column_dot(F, 1, F, 2),         0.5 * column_dot(F, 2, F, 0)};
}

/// Its derivative along dF: the symmetric part of F'dF.
inline PackStrain green_strain_tangent(const Matrix3<Pack>& F, const Matrix3<Pack>& dF) {
    const auto symmetric = [&](int i, int j) { return 0.5 * (column_dot(F, i, dF, j) + column_dot(F, j, dF, i)); };
    return {column_dot(F, 0, dF, 0), column_dot(F, 1, dF, 1), column_dot(F, 2, dF, 2), symmetric(0, 1), symmetric(1, 2), symmetric(2, 0)};
}

/// The trace-free part of a symmetric tensor given as (xx, yy, zz, xy, yz, zx).
inline Matrix3<Pack> deviator(const PackStrain& e) {
    const Pack mean = (1.0 / 3.0) * (e[0] + e[1] + e[2]);
    Matrix3<Pack> D;
    for (int i = 0; i < 3; ++i) D(i, i) = e[static_cast<std::size_t>(i)] - mean;
    D(0, 1) = D(1, 0) = e[3];
    D(1, 2) = D(2, 1) = e[4];
    D(2, 0) = D(0, 2) = e[5];
    return D;
}

/// Blocks K_ab += G_a A G_b for a >= b: the pull-back of a 9 x 9 tangent to the nodes. A is symmetric.
template <int N>
void add_pulled_back(const Matrix9<Pack>& A, const Eigen::Matrix<Pack, N, 3>& G, const Pack& weight, PackOutput<N>& out) {
    for (int b = 0; b < N; ++b) {
        const Pack g0 = weight * G(b, 0), g1 = weight * G(b, 1), g2 = weight * G(b, 2);
        Eigen::Matrix<Pack, 9, 3> AG;
        for (int k = 0; k < 3; ++k)
            for (int row = 0; row < 9; ++row) AG(row, k) = A(row, k) * g0 + A(row, k + 3) * g1 + A(row, k + 6) * g2;
        for (int a = b; a < N; ++a) {
            Matrix3<Pack>& block = out.hessian[static_cast<std::size_t>(lower_block<N>(a, b))];
            for (int k = 0; k < 3; ++k)
                for (int i = 0; i < 3; ++i) block(i, k) += G(a, 0) * AG(i, k) + G(a, 1) * AG(i + 3, k) + G(a, 2) * AG(i + 6, k);
        }
    }
}

/// Adds the Kelvin-Voigt response of one point: potential mu_v / rate_factor |dev Edot|^2, Edot = rate_factor E(F) + history.
/// Its gradient is F S with S = 2 mu_v dev Edot, the schema's second Piola stress, and its Hessian is symmetric: a strain
/// rate differenced like the velocity keeps every step a minimisation.
template <bool WithHessian>
void add_viscous_response(const Matrix3<Pack>& F, const PackInput& in, const double* history, Pack& value, Matrix3<Pack>& P, Matrix9<Pack>& A) {
    PackStrain rate = green_strain(F);
    for (int i = 0; i < 6; ++i) {
        Pack& r = rate[static_cast<std::size_t>(i)];
        r = in.rate_factor * r + load_pack(entry(history, i));
    }
    const Matrix3<Pack> D = deviator(rate), S = D * (2.0 * in.viscous_mu);
    if (in.rate_factor > 0.0) value += (1.0 / in.rate_factor) * in.viscous_mu * double_dot(D, D);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) P(i, j) += F(i, 0) * S(0, j) + F(i, 1) * S(1, j) + F(i, 2) * S(2, j);
    if constexpr (WithHessian) {
        Matrix3<Pack> B;
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) B(i, j) = F(i, 0) * F(j, 0) + F(i, 1) * F(j, 1) + F(i, 2) * F(j, 2);
        const Pack scale = 2.0 * in.viscous_mu * in.rate_factor;
        for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
            Pack value_ikjl = F(i, l) * F(k, j);
            if (j == l) value_ikjl += B(i, k);
            A(row, column) += scale * (0.5 * value_ikjl - (1.0 / 3.0) * F(i, j) * F(k, l));
            if (i == k) A(row, column) += S(j, l);
        });
    }
}

/// Hourglass strains h = F^-1 x gamma and the map dh = F^-1 dx Gamma'.
struct HourglassStrain {
    Matrix3<Pack> F_inverse;
    Eigen::Matrix<Pack, 3, 4> strain;
    Eigen::Matrix<Pack, 8, 4> Gamma;
};

/// Its derivative along dx.
inline Eigen::Matrix<Pack, 3, 4> hourglass_tangent(const HourglassStrain& h, const Eigen::Matrix<Pack, 3, 8>& dx) {
    Eigen::Matrix<Pack, 3, 4> result;
    for (int s = 0; s < 4; ++s) {
        Pack spatial[3];
        for (int i = 0; i < 3; ++i) {
            spatial[i] = h.Gamma(0, s) * dx(i, 0);
            for (int a = 1; a < 8; ++a) spatial[i] += h.Gamma(a, s) * dx(i, a);
        }
        for (int i = 0; i < 3; ++i) result(i, s) = h.F_inverse(i, 0) * spatial[0] + h.F_inverse(i, 1) * spatial[1] + h.F_inverse(i, 2) * spatial[2];
    }
    return result;
}

inline HourglassStrain hourglass_strain(const Eigen::Matrix<Pack, 3, 8>& x, const Eigen::Matrix<Pack, 8, 3>& G, const PackHourglass& geometry) {
    HourglassStrain h;
    const Matrix3<Pack> F = deformation_gradient<8>(x, G);
    const Matrix3<Pack> C = cofactor(F);
    const Pack inverse_J = 1.0 / (F(0, 0) * C(0, 0) + F(1, 0) * C(1, 0) + F(2, 0) * C(2, 0));
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) h.F_inverse(i, j) = inverse_J * C(j, i);
    for (int s = 0; s < 4; ++s) {
        Pack amplitude[3];
        for (int i = 0; i < 3; ++i) {
            amplitude[i] = x(i, 0) * geometry.gamma(0, s);
            for (int a = 1; a < 8; ++a) amplitude[i] += x(i, a) * geometry.gamma(a, s);
        }
        for (int i = 0; i < 3; ++i) h.strain(i, s) = h.F_inverse(i, 0) * amplitude[0] + h.F_inverse(i, 1) * amplitude[1] + h.F_inverse(i, 2) * amplitude[2];
    }
    for (int s = 0; s < 4; ++s)
        for (int a = 0; a < 8; ++a)
            h.Gamma(a, s) = geometry.gamma(a, s) - (G(a, 0) * h.strain(0, s) + G(a, 1) * h.strain(1, s) + G(a, 2) * h.strain(2, s));
    return h;
}

/// h: at the positions of the cell.
template <bool WithHessian>
void add_hourglass(const HourglassStrain& h, const Eigen::Matrix<Pack, 8, 3>& G, const PackHourglass& geometry, const Pack& volume, const PackInput& in,
                   PackOutput<8>& out) {
    using Shapes = Eigen::Matrix<Pack, 3, 4>;
    const HourglassStiffness K(geometry, volume);
    // Rows of B take a motion to the cell's frame: strain rates there are B dx Gamma'.
    Matrix3<Pack> B;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) B(i, j) = column_dot(geometry.frame, i, h.F_inverse, j);
    const auto in_frame = [&](const auto& strain_at) {
        Shapes result;
        for (int s = 0; s < 4; ++s)
            for (int i = 0; i < 3; ++i)
                result(i, s) = geometry.frame(0, i) * strain_at(0, s) + geometry.frame(1, i) * strain_at(1, s) + geometry.frame(2, i) * strain_at(2, s);
        return result;
    };
    const auto product = [](const Shapes& a, const Shapes& b) {
        Pack sum = 0.0;
        for (int k = 0; k < 12; ++k) sum += a(k % 3, k / 3) * b(k % 3, k / 3);
        return sum;
    };
    Shapes stress = Shapes::Constant(Pack(0.0));
    Pack modulus = 0.0;   // of the Hessian
    if (in.elastic) {
        const Shapes strain = in_frame(h.strain);
        const Shapes elastic = K.apply(strain);
        out.energy += 0.5 * in.mu * product(strain, elastic);
        stress += elastic * in.mu;
        modulus += in.mu;
    }
    if (in.viscous) {
        const Shapes rate = in_frame([&](int i, int s) { return in.rate_factor * h.strain(i, s) + load_pack(entry(in.rate_history, 6 + i + 3 * s)); });
        const Shapes viscous = K.apply(rate);
        if (in.rate_factor > 0.0) out.energy += (0.5 / in.rate_factor) * in.viscous_mu * product(rate, viscous);
        stress += viscous * in.viscous_mu;
        modulus += in.rate_factor * in.viscous_mu;
    }
    Shapes T;   // F^-T times the stress, in space
    for (int s = 0; s < 4; ++s)
        for (int i = 0; i < 3; ++i) T(i, s) = B(0, i) * stress(0, s) + B(1, i) * stress(1, s) + B(2, i) * stress(2, s);
    Eigen::Matrix<Pack, 3, 8> f;
    for (int a = 0; a < 8; ++a)
        for (int i = 0; i < 3; ++i)
            f(i, a) = T(i, 0) * h.Gamma(a, 0) + T(i, 1) * h.Gamma(a, 1) + T(i, 2) * h.Gamma(a, 2) + T(i, 3) * h.Gamma(a, 3);
    out.gradient += f;
    if constexpr (WithHessian) {
        std::array<Matrix3<Pack>, 4> M;   // B' diag(K of shape s) B
        for (int s = 0; s < 4; ++s)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i)
                    M[static_cast<std::size_t>(s)](i, j) = modulus * (K.diagonal(0, s) * B(0, i) * B(0, j) + K.diagonal(1, s) * B(1, i) * B(1, j) + K.diagonal(2, s) * B(2, i) * B(2, j));
        std::array<Eigen::Matrix<Pack, 3, 8>, 3> twist;   // derivative of each torsion strain with respect to the nodes
        for (std::size_t t = 0; t < 3; ++t)
            for (int a = 0; a < 8; ++a)
                for (int i = 0; i < 3; ++i) {
                    const HourglassStiffness::Torsion& torsion = K.torsion[t];
                    twist[t](i, a) = torsion.p * h.Gamma(a, torsion.shape_p) * B(torsion.row_p, i) + torsion.q * h.Gamma(a, torsion.shape_q) * B(torsion.row_q, i);
                }
        Eigen::Matrix<Pack, 8, 3> GF;
        for (int j = 0; j < 3; ++j)
            for (int a = 0; a < 8; ++a) GF(a, j) = G(a, 0) * h.F_inverse(0, j) + G(a, 1) * h.F_inverse(1, j) + G(a, 2) * h.F_inverse(2, j);
        const Pack torsion_modulus = modulus * K.torsion_weight;
        for (int b = 0; b < 8; ++b)
            for (int a = b; a < 8; ++a) {
                Matrix3<Pack>& block = out.hessian[static_cast<std::size_t>(lower_block<8>(a, b))];
                std::array<Pack, 4> share;
                for (int s = 0; s < 4; ++s) share[static_cast<std::size_t>(s)] = h.Gamma(a, s) * h.Gamma(b, s);
                for (int j = 0; j < 3; ++j)
                    for (int i = 0; i < 3; ++i) {
                        Pack sum = share[0] * M[0](i, j) + share[1] * M[1](i, j) + share[2] * M[2](i, j) + share[3] * M[3](i, j);
                        sum += torsion_modulus * (twist[0](i, a) * twist[0](j, b) + twist[1](i, a) * twist[1](j, b) + twist[2](i, a) * twist[2](j, b));
                        block(i, j) += sum - f(i, b) * GF(a, j) - GF(b, i) * f(j, a);
                    }
            }
    }
}

/// Energy, gradient and, if asked for, Hessian of one pack of cells at the positions x.
template <bool WithHessian, int N, int Q>
void evaluate_pack(const PackedCells<N, Q>& cells, int pack, const Eigen::Matrix<Pack, 3, N>& x, const PackInput& in, PackOutput<N>& out) {
    const PackGeometry<N, Q>& geometry = cells.geometry[static_cast<std::size_t>(pack)];
    out.energy = 0.0;
    out.gradient.setConstant(Pack(0.0));
    if constexpr (WithHessian)
        for (Matrix3<Pack>& block : out.hessian) block.setConstant(Pack(0.0));
    Pack mean_theta = 0.0;
    Eigen::Matrix<Pack, 3, N> mean_gradient = Eigen::Matrix<Pack, 3, N>::Constant(Pack(0.0));
    std::array<Matrix9<Pack>, WithHessian ? Q : 1> theta_hessian;
    const Pack inverse_volume = 1.0 / geometry.volume;
    const bool split = in.elastic && in.material->has_split();
    const bool mean = cells.mean_volume && split;
    // What the points keep of the bulk modulus, and what acts on the cell's mean.
    const Pack point_kappa = mean ? in.point_bulk.of(in.mu, in.kappa) : in.kappa;
    const bool point_bulk = split && (!mean || cells.most_point_bulk_over_mu != 0.0);

    LawResponse<Pack> law;
    for (std::size_t q = 0; q < Q; ++q) {
        const Eigen::Matrix<Pack, N, 3>& G = geometry.gradient[q];
        const Pack weight = geometry.weight[q];
        const Matrix3<Pack> F = deformation_gradient<N>(x, G);
        Matrix3<Pack> P = Matrix3<Pack>::Constant(Pack(0.0));
        Matrix9<Pack> A;
        Pack density = 0.0;
        if constexpr (WithHessian) A.setConstant(Pack(0.0));
        if (in.elastic) {
            in.material->respond(F, in.mu, in.kappa, WithHessian, law);
            density += law.distortion.value;
            P += law.distortion.gradient;
            if constexpr (WithHessian) A += law.distortion.hessian;
            if (mean) {
                mean_theta += weight * inverse_volume * law.volume.value;
                add_nodal_forces<N>(law.volume.gradient * weight, G, mean_gradient);
                if constexpr (WithHessian) theta_hessian[q] = law.volume.hessian;
            }
            if (point_bulk) {
                const ScalarFunctionOf<Pack> U = in.material->bulk(law.volume.value, point_kappa);
                density += U.value;
                P += law.volume.gradient * U.first;
                if constexpr (WithHessian) {
                    const Pack p = in.pressure && !mean ? load_pack(entry(in.pressure, static_cast<int>(q))) : U.first;
                    for_each_tangent_entry([&](int row, int column, int i, int j, int k, int l) {
                        A(row, column) += U.second * law.volume.gradient(i, j) * law.volume.gradient(k, l) + p * law.volume.hessian(row, column);
                    });
                }
            }
        }
        if (in.viscous) add_viscous_response<WithHessian>(F, in, in.rate_history + 6 * static_cast<int>(q) * pack_width, density, P, A);
        out.energy += weight * density;
        add_nodal_forces<N>(P * weight, G, out.gradient);
        if constexpr (WithHessian) add_pulled_back<N>(A, G, weight, out);
    }

    if (mean) {
        const ScalarFunctionOf<Pack> U = in.material->bulk(mean_theta, in.kappa - point_kappa);
        out.energy += geometry.volume * U.value;
        out.gradient += mean_gradient * U.first;
        if constexpr (WithHessian) {
            const Pack p = in.pressure ? load_pack(in.pressure) : U.first;
            for (std::size_t q = 0; q < Q; ++q) add_pulled_back<N>(theta_hessian[q], geometry.gradient[q], p * geometry.weight[q], out);
            const Pack stiffness = U.second * inverse_volume;
            for (int b = 0; b < N; ++b)
                for (int a = b; a < N; ++a) {
                    Matrix3<Pack>& block = out.hessian[static_cast<std::size_t>(lower_block<N>(a, b))];
                    for (int j = 0; j < 3; ++j)
                        for (int i = 0; i < 3; ++i) block(i, j) += stiffness * mean_gradient(i, a) * mean_gradient(j, b);
                }
        }
    }
    if constexpr (N == 8 && Q == 1)
        if (!cells.hourglass.empty()) {
            const PackHourglass& shape = cells.hourglass[static_cast<std::size_t>(pack)];
            add_hourglass<WithHessian>(hourglass_strain(x, geometry.gradient[0], shape), geometry.gradient[0], shape, geometry.volume, in, out);
        }
}

}  // namespace myo
