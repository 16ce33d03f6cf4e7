#pragma once

#include <algorithm>
#include <array>
#include <experimental/simd>
#include <type_traits>
#include <utility>

#include "base/set_where.hpp"
#include "solver/supernodal_pattern.hpp"

namespace myo::solver {

/// SIMD vector with one lane per right-hand side.
template <class Scalar, int K>
using Lanes = std::experimental::simd<Scalar, std::experimental::simd_abi::deduce_t<Scalar, K>>;

struct FactorBlockPolicy {
    /// Block size of the triangular solves: columns processed together, and rows of a diagonal block. One cache line of
    /// doubles.
    int diagonal_block = 8;
};
inline constexpr FactorBlockPolicy factor_block_policy;

/// Dense block of one supernode of a Cholesky factor, with triangular solves for K right-hand sides.
///
/// rows x columns, column-major with leading dimension `stride`; the first `columns` rows are L11, the others L21. Each
/// diagonal block L_d of FactorBlockPolicy::diagonal_block rows is stored as its inverse L_d^-1, zero above the
/// diagonal. Solves then consist of products, without divisions or dependent substitutions inside a block.
template <class Scalar, int K>
struct FactorBlock {
    using Lane = Lanes<Scalar, K>;
    static constexpr int step = factor_block_policy.diagonal_block;
    const Scalar* values;       // rows x columns, not owned
    int stride, rows, columns;  // leading dimension; sizes of the block

    const Scalar* column(int c) const {
        return values + static_cast<std::size_t>(c) * static_cast<std::size_t>(stride);
    }

    /// Forward substitution on one supernode: y1 <- L11^-1 y1, then y2 <- y2 - L21 y1.
    /// @param y  `rows` entries, own columns first
    void forward(Lane* y) const {
        for (int start = 0; start < columns; start += step) {
            const int end = std::min(start + step, columns);
            std::array<Lane, step> right;
            std::copy(y + start, y + end, right.begin());
            for (int r = start; r < end; ++r) {
                y[r] = column(start)[r] * right[0];
                for (int c = start + 1; c <= r; ++c) y[r] += column(c)[r] * right[static_cast<std::size_t>(c - start)];
            }
            int r = end;
            for (; r + 4 <= rows; r += 4) {  // four rows share the loads of y
                Lane sum0 = y[r], sum1 = y[r + 1], sum2 = y[r + 2], sum3 = y[r + 3];
                for (int c = start; c < end; ++c) {
                    const Scalar* at = column(c) + r;
                    sum0 -= at[0] * y[c];
                    sum1 -= at[1] * y[c];
                    sum2 -= at[2] * y[c];
                    sum3 -= at[3] * y[c];
                }
                y[r] = sum0;
                y[r + 1] = sum1;
                y[r + 2] = sum2;
                y[r + 3] = sum3;
            }
            for (; r < rows; ++r)
                for (int c = start; c < end; ++c) y[r] -= column(c)[r] * y[c];
        }
    }

    /// Backward substitution on one supernode: y1 <- L11^-T (y1 - L21' y2). y2 holds the solution of the rows below.
    void backward(Lane* y) const {
        for (int start = (columns - 1) / step * step; start >= 0; start -= step) {
            const int end = std::min(start + step, columns);
            std::array<Lane, step> sum;
            std::copy(y + start, y + end, sum.begin());
            if (end - start == step) {
                const Scalar* at = column(start);
                for (int r = end; r < rows; ++r)
                    for (std::size_t k = 0; k < step; ++k)
                        sum[k] -= at[k * static_cast<std::size_t>(stride) + static_cast<std::size_t>(r)] * y[r];
            } else {
                for (int c = start; c < end; ++c)
                    for (int r = end; r < rows; ++r) sum[static_cast<std::size_t>(c - start)] -= column(c)[r] * y[r];
            }
            for (int c = start; c < end; ++c) {
                y[c] = column(c)[c] * sum[static_cast<std::size_t>(c - start)];
                for (int r = c + 1; r < end; ++r) y[c] += column(c)[r] * sum[static_cast<std::size_t>(r - start)];
            }
        }
    }
};

/// Specialisation for a single right-hand side. With no lanes to fill, products run down the columns, one register of
/// rows at a time; y and the columns are zero-padded to the stride, so that loops need no remainder.
template <class Scalar>
struct FactorBlock<Scalar, 1> {
    using Lane = Scalar;
    using Rows = std::experimental::native_simd<Scalar>;
    using Mask = typename Rows::mask_type;
    static constexpr int step = factor_block_policy.diagonal_block, width = static_cast<int>(Rows::size());
    static_assert(SupernodalPattern::stride_unit % width == 0);
    const Scalar* values;
    int stride, rows, columns;

    const Scalar* column(int c) const {
        return values + static_cast<std::size_t>(c) * static_cast<std::size_t>(stride);
    }

    /// See the general template; y has `stride` entries.
    void forward(Scalar* y) const {
        for (int start = 0; start < columns; start += step) {
            if (columns - start >= step)
                forward_columns<step>(start, y);
            else
                for_few(columns - start, [&](auto n) { forward_columns<n.value>(start, y); });
        }
    }
    /// See the general template; y has `stride` entries.
    void backward(Scalar* y) const {
        for (int start = (columns - 1) / step * step; start >= 0; start -= step) {
            if (columns - start >= step)
                backward_columns<step>(start, y);
            else
                for_few(columns - start, [&](auto n) { backward_columns<n.value>(start, y); });
        }
    }

private:
    /// Calls visit with n as a compile-time constant, 1 <= n < step, so that the inner loops unroll.
    template <class Visit>
    static void for_few(int n, const Visit& visit) {
        [&]<std::size_t... k>(std::index_sequence<k...>) {
            ((n == static_cast<int>(k) + 1 ? visit(std::integral_constant<int, static_cast<int>(k) + 1>{}) : void()),
             ...);
        }
        (std::make_index_sequence<step - 1>{});
    }

    static Rows load(const Scalar* at) { return Rows(at, std::experimental::element_aligned); }
    /// First row of the register that contains row `first`.
    static int register_of(int first) { return first / width * width; }
    /// Lanes of that register with row >= `first`.
    static Mask from(int first) {
        return Rows([](auto lane) { return static_cast<Scalar>(lane); }) >= static_cast<Scalar>(first % width);
    }

    /// Forward substitution with N columns. L11 acts on the N own rows; its result is broadcast and L21 is applied
    /// register by register. The register that contains both own rows and rows below is masked.
    template <int N>
    void forward_columns(int start, Scalar* y) const {
        const Scalar* const at = column(start);
        const auto n = static_cast<std::size_t>(stride);
        std::array<Scalar, N> own{};
        for (std::size_t c = 0; c < N; ++c)
            for (std::size_t r = c; r < N; ++r)
                own[r] += at[c * n + static_cast<std::size_t>(start) + r] * y[static_cast<std::size_t>(start) + c];
        std::copy(own.begin(), own.end(), y + start);
        const int end = start + N;
        if (end >= rows) return;
        std::array<Rows, N> factor;
        for (std::size_t c = 0; c < N; ++c) factor[c] = own[c];
        const auto product = [&](int r) {
            Rows sum = load(at + r) * factor[0];
            for (std::size_t c = 1; c < N; ++c) sum += load(at + c * n + r) * factor[c];
            return sum;
        };
        int r = register_of(end);
        if (r < end) {
            Rows sum = product(r);
            set_where(!from(end), sum, Scalar(0));
            (load(y + r) - sum).copy_to(y + r, std::experimental::element_aligned);
            r += width;
        }
        for (; r < rows; r += width) (load(y + r) - product(r)).copy_to(y + r, std::experimental::element_aligned);
    }

    template <int N>
    void backward_columns(int start, Scalar* y) const {
        // Transposed products: one dot product per column over the rows below, accumulated in registers and reduced
        // once.
        const Scalar* const at = column(start);
        const auto n = static_cast<std::size_t>(stride);
        const int end = start + N;
        std::array<Rows, N> sums;
        sums.fill(Rows(0));
        int r = register_of(end);
        if (r < end && end < rows) {
            Rows below = load(y + r);
            set_where(!from(end), below, Scalar(0));
            for (std::size_t c = 0; c < N; ++c) sums[c] = load(at + c * n + r) * below;
        }
        if (r < end) r += width;
        for (; r < rows; r += width) {
            const Rows below = load(y + r);
            for (std::size_t c = 0; c < N; ++c) sums[c] += load(at + c * n + r) * below;
        }
        std::array<Scalar, N> own;
        for (std::size_t c = 0; c < N; ++c)
            own[c] = y[static_cast<std::size_t>(start) + c] - std::experimental::reduce(sums[c]);
        for (std::size_t c = 0; c < N; ++c) {
            Scalar value = 0;
            for (std::size_t r2 = c; r2 < N; ++r2) value += at[c * n + static_cast<std::size_t>(start) + r2] * own[r2];
            y[static_cast<std::size_t>(start) + c] = value;
        }
    }
};

}  // namespace myo::solver
