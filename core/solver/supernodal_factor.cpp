#include "solver/supernodal_factor.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/cancellation.hpp"
#include "base/parallel.hpp"
#include "solver/factor_block.hpp"

namespace myo::solver {
namespace {

/// Visits all supernodes of the given subtrees: children before parents (upwards), or parents before children
/// (downwards). Independent branches run in parallel; a subtree of the cut runs on one thread in index order.
template <class Visit>
void climb(const SupernodalPattern& p, const std::vector<int>& supernodes, bool downwards, const Visit& visit) {
    parallel_ranges(static_cast<int>(supernodes.size()), 1, [&](int first, int end) {
        for (int k = first; k < end; ++k) {
            const int s = supernodes[static_cast<std::size_t>(k)], start = p.subtree_start[static_cast<std::size_t>(s)];
            if (start >= 0 && downwards)
                for (int t = s; t >= start; --t) visit(t);
            else if (start >= 0)
                for (int t = start; t <= s; ++t) visit(t);
            else {
                if (downwards) visit(s);
                climb(p, p.children[static_cast<std::size_t>(s)], downwards, visit);
                if (!downwards) visit(s);
            }
        }
    });
}

/// Indices of the rows below supernode s in the rows of its parent.
const int* parent_positions(const SupernodalPattern& p, int s) {
    return p.parent_position.data() + p.first_row[static_cast<std::size_t>(s)] + p.columns(s);
}

/// Replaces a lower triangular matrix by its inverse and sets the entries above the diagonal to zero.
template <class Block>
void invert_lower(Block L) {
    const Eigen::Index n = L.rows();
    L.template triangularView<Eigen::StrictlyUpper>().setZero();
    // Column c of the inverse by forward substitution: sum_k L(r, k) X(k, c) = 0 for r > c.
    for (Eigen::Index c = 0; c < n; ++c) {
        L(c, c) = 1 / L(c, c);
        for (Eigen::Index r = c + 1; r < n; ++r) {
            auto sum = L(r, c) * L(c, c);
            for (Eigen::Index k = c + 1; k < r; ++k) sum += L(r, k) * L(k, c);
            L(r, c) = -sum / L(r, r);
        }
    }
}

/// Numeric multifrontal factorisation of all supernodes.
template <class Scalar>
class Factorisation {
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using Block = Eigen::Map<Matrix, 0, Eigen::OuterStride<>>;

public:
    Factorisation(const SupernodalPattern& pattern, SupernodalFactor<Scalar>& factor)
        : p_(pattern), factor_(factor), left_(static_cast<std::size_t>(pattern.supernodes())) {}

    bool run() {
        climb(p_, p_.roots, false, [&](int s) { factor_supernode(s); });
        return definite_;
    }

private:
    Block block(int s) {
        return {factor_.values.data() + p_.first_value[static_cast<std::size_t>(s)], p_.row_count(s), p_.columns(s),
                Eigen::OuterStride<>(p_.row_stride(s))};
    }

    /// Extend-add: adds the update matrix of child c to the parent's block L and to the parent's update matrix.
    void assemble(int c, Block& L, Matrix& left) {
        Matrix& from = left_[static_cast<std::size_t>(c)];
        const int* position = parent_positions(p_, c);
        const auto columns = static_cast<int>(L.cols());
        // The child's rows are ascending in the parent, so the lower triangle maps into the lower triangle. A column
        // either belongs to the parent's own columns or to its update matrix.
        for (Eigen::Index j = 0; j < from.cols(); ++j) {
            const int target = position[j];
            Scalar* to = target < columns ? L.col(target).data() : left.col(target - columns).data() - columns;
            const Scalar* values = from.col(j).data();
            for (Eigen::Index i = j; i < from.rows(); ++i) to[position[i]] += values[i];
        }
        from.resize(0, 0);  // freed at once: the peak memory is that of the active front
    }

    /// Partial factorisation: L11 L11' = A11, L21 = A21 L11^-T, update matrix S = -L21 L21' plus the children's.
    void factor_supernode(int s) {
        // Another thread met a negative pivot, or the task was cancelled: then nothing is factorised.
        if (!definite_.load(std::memory_order_relaxed)) return;
        if (cancellation_requested()) {
            definite_ = false;
            return;
        }
        Block L = block(s);
        const Eigen::Index columns = L.cols(), below = L.rows() - columns;
        Matrix& left = left_[static_cast<std::size_t>(s)];
        left = Matrix::Zero(below, below);
        for (const int c : p_.children[static_cast<std::size_t>(s)]) assemble(c, L, left);
        Eigen::Ref<Matrix> top = L.topRows(columns);
        const Eigen::LLT<Eigen::Ref<Matrix>> cholesky(top);  // in place
        // A pivot that is no number passes the test of its sign, and makes the last one of its block the same.
        if (cholesky.info() != Eigen::Success || !(top(columns - 1, columns - 1) > Scalar(0))) {
            definite_ = false;
            return;
        }
        if (below > 0) {
            auto bottom = L.bottomRows(below);
            top.template triangularView<Eigen::Lower>().transpose().template solveInPlace<Eigen::OnTheRight>(bottom);
            left.template selfadjointView<Eigen::Lower>().rankUpdate(bottom, Scalar(-1));
        }
        // Inverted diagonal blocks, see FactorBlock. Only after L21 is complete, which needs L11 itself.
        constexpr Eigen::Index block = factor_block_policy.diagonal_block;
        for (Eigen::Index start = 0; start < columns; start += block) {
            const Eigen::Index size = std::min(block, columns - start);
            invert_lower(L.block(start, start, size, size));
        }
    }

    const SupernodalPattern& p_;
    SupernodalFactor<Scalar>& factor_;
    // per supernode, lower triangle: update matrix for the rows below, -L21 L21' plus the children's
    std::vector<Matrix> left_;
    std::atomic<bool> definite_ = true;  // cleared by the first non-positive pivot, or by cancellation
};

/// Triangular solves on K columns. Each supernode works on a private copy of its rows, so that branches do not share
/// memory and sums are taken in the children's order.
template <class Scalar, int K>
class Substitution {
    using Block = FactorBlock<Scalar, K>;

public:
    using Lane = typename Block::Lane;

    Substitution(const SupernodalPattern& pattern, const SupernodalFactor<Scalar>& factor)
        : p_(pattern), factor_(factor), local_(pattern.rows.size()) {}

    /// Solves in place.
    /// @param y  one entry per row of P A P'; right-hand side in, solution out
    void run(std::vector<Lane>& y) {
        climb(p_, p_.roots, false, [&](int s) { forward(s, y); });
        climb(p_, p_.roots, true, [&](int s) { backward(s, y); });
    }

private:
    /// Private copy of the rows of supernode s, padded to the stride.
    Lane* local(int s) { return local_.data() + p_.first_row[static_cast<std::size_t>(s)]; }
    Block block(int s) const {
        return {factor_.values.data() + p_.first_value[static_cast<std::size_t>(s)], p_.row_stride(s), p_.row_count(s),
                p_.columns(s)};
    }

    void forward(int s, const std::vector<Lane>& y) {
        Lane* values = local(s);
        const int own = p_.columns(s);
        std::copy_n(y.begin() + p_.first_column[static_cast<std::size_t>(s)], own, values);
        // Rows below start at 0: they collect only what this subtree subtracts.
        std::fill(values + own, values + p_.row_stride(s), Lane(0));
        for (const int c : p_.children[static_cast<std::size_t>(s)]) {
            const Lane* from = local(c) + p_.columns(c);
            const int* position = parent_positions(p_, c);
            const int count = p_.row_count(c) - p_.columns(c);
            for (int i = 0; i < count; ++i) values[position[i]] += from[i];
        }
        block(s).forward(values);
    }

    void backward(int s, std::vector<Lane>& y) {
        // The rows below are already solved in the parent and are copied from there.
        Lane* values = local(s);
        const int own = p_.columns(s), below = p_.row_count(s) - own;
        if (below > 0) {
            const Lane* from = local(p_.parent[static_cast<std::size_t>(s)]);
            const int* position = parent_positions(p_, s);
            for (int i = 0; i < below; ++i) values[own + i] = from[position[i]];
        }
        block(s).backward(values);
        std::copy_n(values, own, y.begin() + p_.first_column[static_cast<std::size_t>(s)]);
    }

    const SupernodalPattern& p_;
    const SupernodalFactor<Scalar>& factor_;
    std::vector<Lane, Eigen::aligned_allocator<Lane>> local_;
};

/// Solves the columns first ... first + count - 1 of B together, count <= K.
template <class Scalar, int K>
void solve_columns(const SupernodalPattern& pattern, const SupernodalFactor<Scalar>& factor,
                   const Eigen::Ref<const Eigen::MatrixXd>& B, Eigen::Index first, Eigen::Index count,
                   Eigen::MatrixXd& X) {
    using Run = Substitution<Scalar, K>;
    const auto n = static_cast<std::size_t>(pattern.size());
    std::vector<typename Run::Lane> y(n);
    auto* numbers = reinterpret_cast<Scalar*>(y.data());  // K interleaved numbers per row
    // Each column is normalised by its largest entry: single precision overflows where double precision does not.
    std::array<double, K> size{};  // single precision overflows where double does not: each column at its own size
    for (Eigen::Index k = 0; k < count; ++k)
        size[static_cast<std::size_t>(k)] = std::max(B.col(first + k).cwiseAbs().cwiseProduct(factor.scale).maxCoeff(),
                                                     1e-300);
    for (std::size_t i = 0; i < n; ++i) {
        const int from = pattern.permutation[i];
        for (Eigen::Index k = 0; k < count; ++k)
            numbers[i * K + static_cast<std::size_t>(k)] = static_cast<Scalar>(B(from, first + k) * factor.scale(from) /
                                                                               size[static_cast<std::size_t>(k)]);
        for (auto k = static_cast<std::size_t>(count); k < K; ++k) numbers[i * K + k] = Scalar(0);
    }
    Run(pattern, factor).run(y);
    for (std::size_t i = 0; i < n; ++i) {
        const int to = pattern.permutation[i];
        for (Eigen::Index k = 0; k < count; ++k)
            X(to, first + k) = static_cast<double>(numbers[i * K + static_cast<std::size_t>(k)]) * factor.scale(to) *
                               size[static_cast<std::size_t>(k)];
    }
}

}  // namespace

template <class Scalar>
bool factorize(const SupernodalPattern& pattern, const SymmetricSparse& lower, SupernodalFactor<Scalar>& factor) {
    assert(lower.rows() == pattern.size() && static_cast<std::size_t>(lower.nonZeros()) == pattern.entry.size());
    factor.scale.resize(lower.rows());
    factor.values.assign(static_cast<std::size_t>(pattern.value_count()), Scalar(0));
    // Symmetric diagonal scaling to a unit diagonal keeps the entries within the range of single precision.
    bool positive = true;
    for (int j = 0; j < lower.outerSize(); ++j) {
        const double diagonal = lower.coeff(j, j);
        positive = positive && diagonal > 0.0 && std::isfinite(diagonal);
        factor.scale(j) = 1.0 / std::sqrt(diagonal);
    }
    if (positive) {
        const int* start = lower.outerIndexPtr();
        for (int j = 0; j < lower.outerSize(); ++j)
            for (int k = start[j]; k < start[j + 1]; ++k)
                factor.values[pattern.entry[static_cast<std::size_t>(k)]] = static_cast<Scalar>(
                    lower.valuePtr()[k] * factor.scale(j) * factor.scale(lower.innerIndexPtr()[k]));
        positive = Factorisation<Scalar>(pattern, factor).run();
    }
    if (!positive) factor = {};
    return positive;
}

template <class Scalar>
Eigen::MatrixXd solve(const SupernodalPattern& pattern, const SupernodalFactor<Scalar>& factor,
                      const Eigen::Ref<const Eigen::MatrixXd>& B) {
    assert(B.rows() == pattern.size() && !factor.empty());
    Eigen::MatrixXd X(B.rows(), B.cols());
    for (Eigen::Index first = 0; first < B.cols();) {
        const Eigen::Index count = B.cols() - first;
        if (count == 1)
            solve_columns<Scalar, 1>(pattern, factor, B, first++, 1, X);
        else if (count <= 4)
            solve_columns<Scalar, 4>(pattern, factor, B, std::exchange(first, first + count), count, X);
        else if (count <= 8)
            solve_columns<Scalar, 8>(pattern, factor, B, std::exchange(first, first + count), count, X);
        else
            solve_columns<Scalar, 16>(pattern, factor, B, std::exchange(first, first + 16),
                                      std::min<Eigen::Index>(count, 16), X);
    }
    return X;
}

template bool factorize(const SupernodalPattern&, const SymmetricSparse&, SupernodalFactor<float>&);
template bool factorize(const SupernodalPattern&, const SymmetricSparse&, SupernodalFactor<double>&);
template Eigen::MatrixXd solve(const SupernodalPattern&, const SupernodalFactor<float>&,
                               const Eigen::Ref<const Eigen::MatrixXd>&);
template Eigen::MatrixXd solve(const SupernodalPattern&, const SupernodalFactor<double>&,
                               const Eigen::Ref<const Eigen::MatrixXd>&);

}  // namespace myo::solver
