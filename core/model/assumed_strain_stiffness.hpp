#pragma once

#include <array>

#include "model/assumed_strain_points.hpp"

namespace myo::model {

/// Second derivative of a pack's energy with respect to its nodal positions.
///
/// H = sum_m sign(q, m) H_m over sets m of edges, where the sign is the product of the coordinates of corner q in m.
/// The second derivatives with respect to H_m and H_n depend only on the symmetric difference of the two sets, so eight
/// sums over the corners hold all of them. They are then transformed to plane and edge strains, to F0 and q, and to the
/// nodes.
template <>
class StiffnessSum<PackAssumedStrain> {
public:
    /// @param matrix  receives the blocks in finish()
    StiffnessSum(const PointKinematics<PackAssumedStrain>& points, PackMatrix<8>& matrix)
        : points_(points), matrix_(matrix), stress_(points) {
        mean_.setConstant(Pack(0.0));
        for (auto& sum : strain_) sum.fill(Pack(0.0));
        for (auto& sum : mixed_)
            for (material::Matrix3<Pack>& block : sum) block.setConstant(Pack(0.0));
    }

    /// Adds point q with A = d2W/dF2 [J] and P = dW/dF [J]. Opposite corners are added in pairs, so q must run in
    /// ascending order.
    void add(int q, const material::Matrix9<Pack>& A, const material::Matrix3<Pack>& P) {
        stress_.add(q, P);
        if (q == 0) {
            mean_ += A;
            return;
        }
        const PackSymmetric& M = points_.stretch(q);
        add_mean(A, full(M));
        const std::array<material::Matrix3<Pack>, 6> stiffness = by_strain(A);
        const material::Matrix3<Pack> Y = full(symmetric_part(transposed_product(points_.mean(), P)));
        // Corner q and corner 9 - q are opposite and share a slot.
        Corner& corner = corners_[static_cast<std::size_t>(q <= 4 ? q - 1 : 8 - q)];
        Corner now;
        std::array<PackSymmetric, 6> lifted;  // dM per unit of a strain
        for (std::size_t b = 0; b < 6; ++b) {
            lifted[b] = lift(b, points_.strain(q));
            // A : F0 dM.
            material::Matrix3<Pack> U = stiffness[0] * lifted[b][0];
            for (std::size_t a = 1; a < 6; ++a) U += stiffness[a] * lifted[b][a];
            now.mixed[b] = times_symmetric(U, M) + times_symmetric(P, lifted[b]);
            const PackSymmetric pulled = symmetric_part(transposed_product(points_.mean(), U));
            const material::Matrix3<Pack> YE = curvature(b, Y);
            for (std::size_t a = 0; a <= b; ++a) now.strain[pair(b, a)] = double_dot(lifted[a], pulled) + entry(a, YE);
        }
        if (q <= 4)
            corner = now;
        else
            add_opposite(q, now, corner);
    }

    /// Transforms the sums to the nodes. Call once, after the last add().
    void finish() {
        // Twelve measures: three per plane, then one per edge. Each has its set of edges and its strain.
        std::array<PackSymmetric, 12> basis;
        std::array<int, 12> set{};
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t m = 0; m < 3; ++m) basis[3 * k + m] = points_.map().basis(k, m), set[3 * k + m] = 1 << k;
            basis[9 + k] = points_.map().bilinear_basis(k), set[9 + k] = 7 ^ (1 << k);
        }
        std::array<std::array<material::Matrix3<Pack>, 4>, 4> shapes;  // d2W/dc dc by (s, t), see AssumedStrainMap
        std::array<std::array<material::Matrix3<Pack>, 4>, 3> mixed;   // [j][s](i, r): d2W / dF0_ij dc(s, r)
        for (auto& row : shapes)
            for (material::Matrix3<Pack>& block : row) block.setConstant(Pack(0.0));
        for (auto& row : mixed)
            for (material::Matrix3<Pack>& block : row) block.setConstant(Pack(0.0));
        for (std::size_t n = 0; n < 12; ++n) {
            // Chain rule from measures to amplitudes: each measure is a sum of at most two amplitudes.
            const auto to_n = amplitudes(n);
            material::Matrix3<Pack> G = zero_tensor();
            for (std::size_t b = 0; b < 6; ++b) G += mixed_[static_cast<std::size_t>(set[n])][b] * basis[n][b];
            for (const auto& [s, r] : to_n) {
                if (s < 0) continue;
                for (std::size_t j = 0; j < 3; ++j)
                    for (int i = 0; i < 3; ++i)
                        mixed[j][static_cast<std::size_t>(s)](i, r) += G(i, static_cast<int>(j));
            }
            // Second derivative with respect to measures m and n: the sum of the symmetric difference of their sets.
            for (std::size_t m = 0; m < 12; ++m) {
                const auto& K = strain_[static_cast<std::size_t>(set[m] ^ set[n])];
                Pack value = 0.0;
                for (std::size_t b = 0; b < 6; ++b) {
                    Pack row = 0.0;
                    for (std::size_t a = 0; a < 6; ++a) row += K[a >= b ? pair(a, b) : pair(b, a)] * basis[m][a];
                    value += row * basis[n][b];
                }
                for (const auto& [s, r] : amplitudes(m))
                    for (const auto& [t, u] : to_n)
                        if (s >= 0 && t >= 0)
                            shapes[static_cast<std::size_t>(s)][static_cast<std::size_t>(t)](r, u) += value;
            }
        }
        to_nodes(shapes, mixed);
    }

private:
    /// Product of the coordinates of corner q over the edges in the set.
    static double sign(int q, int set) {
        double s = 1.0;
        for (int bit = 0; bit < 3; ++bit)
            if (set & (1 << bit) && !((q - 1) & (1 << bit))) s = -s;
        return s;
    }
    /// Index of entry (a, b), a >= b, in the packed lower triangle of a 6 x 6 matrix.
    static constexpr std::size_t pair(std::size_t a, std::size_t b) { return b * 6 - b * (b + 1) / 2 + a; }
    static constexpr std::array<std::array<int, 2>, 6> index{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};

    /// Amplitudes c(s, i) whose sum is the measure; s = -1 marks an unused entry.
    static std::array<std::array<int, 2>, 2> amplitudes(std::size_t measure) {
        const auto k = static_cast<int>(measure < 9 ? measure / 3 : measure - 9), i = (k + 1) % 3, j = (k + 2) % 3;
        if (measure >= 9) return {{{3, k}, {-1, 0}}};
        if (measure % 3 == 0) return {{{j, i}, {-1, 0}}};
        if (measure % 3 == 1) return {{{i, j}, {-1, 0}}};
        return {{{i, i}, {j, j}}};
    }

    /// dM = E + (E H + H E) / 2 for the unit strain E = sym(e_i e_j), off-diagonal entries counted once.
    static PackSymmetric lift(std::size_t b, const PackSymmetric& H) {
        PackSymmetric E;
        E.fill(Pack(0.0));
        E[b] = 1.0;
        PackSymmetric L = anticommutator_half(E, H);
        L[b] += 1.0;
        return L;
    }

    /// Y E for the unit strain b.
    static material::Matrix3<Pack> curvature(std::size_t b, const material::Matrix3<Pack>& Y) {
        const int i = index[b][0], j = index[b][1];
        material::Matrix3<Pack> YE = zero_tensor();
        YE.col(j) += Y.col(i);
        if (i != j) YE.col(i) += Y.col(j);
        return YE;
    }
    /// tr(X E) for the unit strain a.
    static Pack entry(std::size_t a, const material::Matrix3<Pack>& X) {
        const int i = index[a][0], j = index[a][1];
        return i == j ? X(i, i) : X(i, j) + X(j, i);
    }

    /// A : (F0 E) for each unit strain E.
    std::array<material::Matrix3<Pack>, 6> by_strain(const material::Matrix9<Pack>& A) const {
        // A : (F0 e_k e_l').
        const auto column = [&](int k, int l) {
            material::Matrix3<Pack> U;
            for (int row = 0; row < 9; ++row)
                U(row % 3, row / 3) = A(row, 3 * l) * points_.mean()(0, k) + A(row, 1 + 3 * l) * points_.mean()(1, k) +
                                      A(row, 2 + 3 * l) * points_.mean()(2, k);
            return U;
        };
        return {column(0, 0),
                column(1, 1),
                column(2, 2),
                column(0, 1) + column(1, 0),
                column(1, 2) + column(2, 1),
                column(2, 0) + column(0, 2)};
    }

    /// Contribution of one corner to the sums.
    struct Corner {
        std::array<Pack, 21> strain;
        std::array<material::Matrix3<Pack>, 6> mixed;
    };

    /// Adds corner q and the opposite corner. Their signs agree in sets of two edges and differ in sets of one or
    /// three.
    void add_opposite(int q, const Corner& a, const Corner& b) {
        for (std::size_t k = 0; k < 21; ++k) {
            const Pack even = a.strain[k] + b.strain[k], odd = a.strain[k] - b.strain[k];
            for (int m = 0; m < 8; ++m)
                add_signed(strain_[static_cast<std::size_t>(m)][k], is_even(m) ? even : odd, sign(q, m));
        }
        for (std::size_t k = 0; k < 6; ++k)
            for (int e = 0; e < 9; ++e) {
                const Pack x = a.mixed[k](e % 3, e / 3), y = b.mixed[k](e % 3, e / 3), even = x + y, odd = x - y;
                for (int m = 1; m < 7; ++m)
                    add_signed(mixed_[static_cast<std::size_t>(m)][k](e % 3, e / 3), is_even(m) ? even : odd,
                               sign(q, m));
            }
    }
    /// Whether a set has an even number of edges.
    static bool is_even(int set) { return set == 0 || set == 3 || set == 5 || set == 6; }
    /// Adds a value with a sign of 1 or -1.
    static void add_signed(Pack& sum, const Pack& value, double sign) { sum += sign * value; }

    /// mean_ += (I x M) A (I x M), from F = F0 M.
    void add_mean(const material::Matrix9<Pack>& A, const material::Matrix3<Pack>& M) {
        material::Matrix9<Pack> AM;
        for (int l = 0; l < 3; ++l)
            for (int k = 0; k < 3; ++k)
                for (int row = 0; row < 9; ++row)
                    AM(row, k + 3 * l) = A(row, k) * M(l, 0) + A(row, k + 3) * M(l, 1) + A(row, k + 6) * M(l, 2);
        for (int column = 0; column < 9; ++column)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i)
                    mean_(i + 3 * j, column) += AM(i, column) * M(j, 0) + AM(i + 3, column) * M(j, 1) +
                                                AM(i + 6, column) * M(j, 2);
    }

    /// From the amplitudes, whose variation is c(s, i) = edge_i . F0^-1 (dq_s - dF0 h_s), to the nodes. Adds the
    /// geometric term from the second variation of F0^-1.
    void to_nodes(const std::array<std::array<material::Matrix3<Pack>, 4>, 4>& shapes,
                  const std::array<std::array<material::Matrix3<Pack>, 4>, 3>& mixed) {
        const PackAssumedStrain& geometry = points_.map().geometry;
        const material::Matrix3<Pack> E = transposed_product(points_.mean_inverse(), geometry.edges);  // F0^-T edges
        const auto transposed = [](const material::Matrix3<Pack>& A) { return material::Matrix3<Pack>(A.transpose()); };
        const material::Matrix3<Pack> E_transposed = transposed(E);
        std::array<std::array<material::Matrix3<Pack>, 7>, 7> K;  // by columns of F0, then of the shapes
        for (std::size_t n = 0; n < 3; ++n)
            for (std::size_t m = 0; m < 3; ++m)
                for (int k = 0; k < 3; ++k)
                    for (int i = 0; i < 3; ++i)
                        K[m][n](i, k) = mean_(i + 3 * static_cast<int>(m), k + 3 * static_cast<int>(n));
        for (std::size_t s = 0; s < 4; ++s) {
            for (std::size_t j = 0; j < 3; ++j) {
                K[j][3 + s] = product(mixed[j][s], E_transposed);
                K[3 + s][j] = transposed(K[j][3 + s]);
            }
            for (std::size_t t = 0; t < 4; ++t) K[3 + s][3 + t] = product(E, product(shapes[s][t], E_transposed));
        }
        // Nodal map of all 7 columns: F0 = x G and shapes d(F0^-1 q) = F0^-1 dx Gamma.
        Eigen::Matrix<Pack, 8, 7> map;
        const Eigen::Matrix<Pack, 8, 4> gamma = points_.gamma();
        for (int a = 0; a < 8; ++a) {
            for (int j = 0; j < 3; ++j) map(a, j) = geometry.gradient(a, j);
            for (int s = 0; s < 4; ++s) map(a, 3 + s) = gamma(a, s);
        }
        PackNodes<8> f = PackNodes<8>::Constant(Pack(0.0));
        add_nodal(stress_.of_shapes(), gamma, f);
        Eigen::Matrix<Pack, 8, 3> GF;
        for (int j = 0; j < 3; ++j)
            for (int a = 0; a < 8; ++a)
                GF(a, j) = geometry.gradient(a, 0) * points_.mean_inverse()(0, j) +
                           geometry.gradient(a, 1) * points_.mean_inverse()(1, j) +
                           geometry.gradient(a, 2) * points_.mean_inverse()(2, j);
        for (int b = 0; b < 8; ++b) {
            std::array<material::Matrix3<Pack>, 7> V;
            for (std::size_t m = 0; m < 7; ++m) {
                V[m] = K[m][0] * map(b, 0);
                for (std::size_t n = 1; n < 7; ++n) V[m] += K[m][n] * map(b, static_cast<int>(n));
            }
            // K_ab = sum over columns, plus the geometric term -(f_b (GF)_a' + (GF)_b f_a') of the variation of F0^-1.
            for (int a = b; a < 8; ++a) {
                material::Matrix3<Pack>& block = matrix_[static_cast<std::size_t>(lower_block<8>(a, b))];
                for (int j = 0; j < 3; ++j)
                    for (int i = 0; i < 3; ++i) {
                        Pack sum = -f(i, b) * GF(a, j) - GF(b, i) * f(j, a);
                        for (std::size_t m = 0; m < 7; ++m) sum += map(a, static_cast<int>(m)) * V[m](i, j);
                        block(i, j) += sum;
                    }
            }
        }
    }

    const PointKinematics<PackAssumedStrain>& points_;
    PackMatrix<8>& matrix_;
    StressSum<PackAssumedStrain> stress_;
    material::Matrix9<Pack> mean_;                // d2W/dF0 dF0
    std::array<Corner, 4> corners_;               // first corner of each pair, until its opposite is added
    std::array<std::array<Pack, 21>, 8> strain_;  // d2W/dH dH by symmetric difference
    std::array<std::array<material::Matrix3<Pack>, 6>, 8> mixed_;  // d2W/dF0 dH by the set of H; 0 and 7 unused
};

}  // namespace myo::model
