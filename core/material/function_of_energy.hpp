#pragma once

#include "material/material.hpp"

namespace myo::material {

/// Adds g(w) with its derivatives by F to `out`, by the chain rule.
///
/// @param w    with its Hessian if `with_hessian`
/// @param g    g, dg/dw, d2g/dw2 at the value of w
/// @param out  increased; its Hessian must be set if `with_hessian`
template <class T>
void add_function_of(const TensorFunctionOf<T>& w, const ScalarFunctionOf<T>& g, bool with_hessian,
                     TensorFunctionOf<T>& out) {
    out.value += g.value;
    for (int i = 0; i < 9; ++i) out.gradient.data()[i] += g.first * w.gradient.data()[i];
    if (!with_hessian) return;
    for (int j = 0; j < 9; ++j)
        for (int i = 0; i < 9; ++i)
            out.hessian(i, j) += g.first * w.hessian(i, j) + g.second * (w.gradient.data()[i] * w.gradient.data()[j]);
}

}  // namespace myo::material
