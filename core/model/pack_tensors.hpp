#pragma once

#include <Eigen/Core>

#include "material/material.hpp"
#include "material/tensors.hpp"
#include "model/packed_cells.hpp"

namespace myo::model {

// Products of 3 x 3 matrices of Packs, written out: Eigen has no optimised kernels for this scalar type.

/// Zero 3 x 3 matrix.
inline material::Matrix3<Pack> zero_tensor() { return material::Matrix3<Pack>::Constant(Pack(0.0)); }

/// A B.
inline material::Matrix3<Pack> product(const material::Matrix3<Pack>& A, const material::Matrix3<Pack>& B) {
    material::Matrix3<Pack> C;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) C(i, j) = A(i, 0) * B(0, j) + A(i, 1) * B(1, j) + A(i, 2) * B(2, j);
    return C;
}

/// A'B.
inline material::Matrix3<Pack> transposed_product(const material::Matrix3<Pack>& A, const material::Matrix3<Pack>& B) {
    material::Matrix3<Pack> C;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) C(i, j) = A(0, i) * B(0, j) + A(1, i) * B(1, j) + A(2, i) * B(2, j);
    return C;
}

/// A^-1 from cofactors; non-finite for a singular lane.
inline material::Matrix3<Pack> inverse(const material::Matrix3<Pack>& A) {
    const material::Matrix3<Pack> C = material::cofactor(A);
    const Pack scale = 1.0 / (A(0, 0) * C(0, 0) + A(1, 0) * C(1, 0) + A(2, 0) * C(2, 0));
    material::Matrix3<Pack> B;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) B(i, j) = scale * C(j, i);
    return B;
}

/// X G with the nodal vectors in the columns of X, 3 x K.
template <int N, int K>
Eigen::Matrix<Pack, 3, K> nodal_product(const PackNodes<N>& X, const Eigen::Matrix<Pack, N, K>& G) {
    Eigen::Matrix<Pack, 3, K> F;
    for (int j = 0; j < K; ++j)
        for (int i = 0; i < 3; ++i) {
            Pack sum = X(i, 0) * G(0, j);
            for (int a = 1; a < N; ++a) sum += X(i, a) * G(a, j);
            F(i, j) = sum;
        }
    return F;
}

/// nodal += P G', the transpose of nodal_product().
template <int N, int K>
void add_nodal(const Eigen::Matrix<Pack, 3, K>& P, const Eigen::Matrix<Pack, N, K>& G, PackNodes<N>& nodal) {
    for (int a = 0; a < N; ++a)
        for (int i = 0; i < 3; ++i) {
            Pack sum = P(i, 0) * G(a, 0);
            for (int j = 1; j < K; ++j) sum += P(i, j) * G(a, j);
            nodal(i, a) += sum;
        }
}

/// Full matrix of a symmetric tensor.
inline material::Matrix3<Pack> full(const PackSymmetric& s) {
    material::Matrix3<Pack> A;
    A(0, 0) = s[0], A(1, 1) = s[1], A(2, 2) = s[2];
    A(0, 1) = A(1, 0) = s[3];
    A(1, 2) = A(2, 1) = s[4];
    A(2, 0) = A(0, 2) = s[5];
    return A;
}

/// A s for a symmetric tensor s.
inline material::Matrix3<Pack> times_symmetric(const material::Matrix3<Pack>& A, const PackSymmetric& s) {
    material::Matrix3<Pack> C;
    for (int i = 0; i < 3; ++i) {
        C(i, 0) = A(i, 0) * s[0] + A(i, 1) * s[3] + A(i, 2) * s[5];
        C(i, 1) = A(i, 0) * s[3] + A(i, 1) * s[1] + A(i, 2) * s[4];
        C(i, 2) = A(i, 0) * s[5] + A(i, 1) * s[4] + A(i, 2) * s[2];
    }
    return C;
}

/// (A + A') / 2.
inline PackSymmetric symmetric_part(const material::Matrix3<Pack>& A) {
    return {A(0, 0), A(1, 1), A(2, 2), 0.5 * (A(0, 1) + A(1, 0)), 0.5 * (A(1, 2) + A(2, 1)), 0.5 * (A(2, 0) + A(0, 2))};
}

/// a : b.
inline Pack double_dot(const PackSymmetric& a, const PackSymmetric& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2.0 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

/// Half of the anticommutator, (a b + b a) / 2: symmetric.
inline PackSymmetric anticommutator_half(const PackSymmetric& a, const PackSymmetric& b) {
    const Pack xy = a[3] * b[3], yz = a[4] * b[4], zx = a[5] * b[5];
    return {a[0] * b[0] + xy + zx,
            a[1] * b[1] + xy + yz,
            a[2] * b[2] + yz + zx,
            0.5 * ((a[0] + a[1]) * b[3] + (b[0] + b[1]) * a[3] + a[5] * b[4] + a[4] * b[5]),
            0.5 * ((a[1] + a[2]) * b[4] + (b[1] + b[2]) * a[4] + a[3] * b[5] + a[5] * b[3]),
            0.5 * ((a[2] + a[0]) * b[5] + (b[2] + b[0]) * a[5] + a[4] * b[3] + a[3] * b[4])};
}

/// Dot product of column i of A and column j of B.
inline Pack column_dot(const material::Matrix3<Pack>& A, int i, const material::Matrix3<Pack>& B, int j) {
    return A(0, i) * B(0, j) + A(1, i) * B(1, j) + A(2, i) * B(2, j);
}

/// Green-Lagrange strain E = (F'F - I) / 2.
inline PackSymmetric green_strain(const material::Matrix3<Pack>& F) {
    return {0.5 * (column_dot(F, 0, F, 0) - 1.0), 0.5 * (column_dot(F, 1, F, 1) - 1.0),
            0.5 * (column_dot(F, 2, F, 2) - 1.0), 0.5 * column_dot(F, 0, F, 1),
            0.5 * column_dot(F, 1, F, 2),         0.5 * column_dot(F, 2, F, 0)};
}

/// Derivative of the Green-Lagrange strain along dF: symmetric part of F'dF.
inline PackSymmetric green_strain_tangent(const material::Matrix3<Pack>& F, const material::Matrix3<Pack>& dF) {
    return symmetric_part(transposed_product(F, dF));
}

/// Deviatoric part.
inline PackSymmetric deviator(PackSymmetric e) {
    const Pack mean = (1.0 / 3.0) * (e[0] + e[1] + e[2]);
    for (std::size_t i = 0; i < 3; ++i) e[i] -= mean;
    return e;
}

}  // namespace myo::model
