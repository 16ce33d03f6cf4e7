#pragma once

#include <Eigen/Core>

#include "material/material.hpp"

namespace myo::material {

// Declared inline: GCC inlines small templates less readily without the word, and the laws call these at every point.

/// Cofactor matrix cof F = det(F) F^-T; also defined for singular F.
template <class T>
inline Matrix3<T> cofactor(const Matrix3<T>& F) {
    Matrix3<T> C;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
            C(i, j) = F(a, c) * F(b, d) - F(a, d) * F(b, c);
        }
    return C;
}

/// Double contraction A : B.
template <class T>
inline T double_dot(const Matrix3<T>& A, const Matrix3<T>& B) {
    T sum = A(0, 0) * B(0, 0);
    for (int k = 1; k < 9; ++k) sum += A(k % 3, k / 3) * B(k % 3, k / 3);
    return sum;
}

/// Calls f(i + 3 j, k + 3 l, i, j, k, l) for each entry of a tangent dP_ij / dF_kl.
template <class Function>
inline void for_each_tangent_entry(const Function& f) {
    for (int l = 0; l < 3; ++l)
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i) f(i + 3 * j, k + 3 * l, i, j, k, l);
}

}  // namespace myo::material
