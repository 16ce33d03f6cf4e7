#include "solver/conjugate_gradient.hpp"

#include <algorithm>
#include <experimental/simd>
#include <vector>

#include "base/cancellation.hpp"
#include "base/parallel.hpp"

namespace myo::solver {
namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;

struct ConjugateGradientPolicy {
    int wide = 16;
};
constexpr ConjugateGradientPolicy conjugate_gradient_policy;

RowVectorXd column_dots(const MatrixXd& A, const MatrixXd& B) { return A.cwiseProduct(B).colwise().sum(); }

/// True if all columns and rows come in aligned groups of three with equal patterns, as for nodal coordinates.
bool has_blocks_of_three(const SymmetricSparse& lower) {
    const int* start = lower.outerIndexPtr();
    const int* rows = lower.innerIndexPtr();
    if (lower.outerSize() % 3 != 0) return false;
    for (int j = 0; j < lower.outerSize(); j += 3) {
        const int length = start[j + 1] - start[j];
        // Columns j, j + 1, j + 2 of a lower triangle start at the diagonal: each is one entry shorter than the one
        // before.
        if (length < 3 || length % 3 != 0 || rows[start[j]] != j || start[j + 2] - start[j + 1] != length - 1 ||
            start[j + 3] - start[j + 2] != length - 2)
            return false;
        for (int e = 0; e < length; e += 3)
            if (rows[start[j] + e + 2] != rows[start[j] + e] + 2) return false;
        if (!std::equal(rows + start[j] + 1, rows + start[j] + length, rows + start[j + 1]) ||
            !std::equal(rows + start[j] + 2, rows + start[j] + length, rows + start[j + 2]))
            return false;
    }
    return true;
}

/// y += A x for the columns j, j + 1, j + 2 in 3 x 3 blocks: x and y are loaded once for nine entries, and the mirrored
/// upper triangle is applied in the same pass.
template <class Lane>
void add_block_column(const SymmetricSparse& lower, int j, const std::vector<Lane>& x, std::vector<Lane>& y) {
    const int first = lower.outerIndexPtr()[j], length = lower.outerIndexPtr()[j + 1] - first;
    const int* rows = lower.innerIndexPtr() + first;
    const double* a = lower.valuePtr() + first;  // indexed by the entries of the first column
    const double *b = a + length - 1, *c = b + length - 2;
    const auto at = static_cast<std::size_t>(j);
    // Copies stay in registers. References would be read again after every store to y: measured 33 % slower for xa, xb
    // and xc, 7 % for xi, at 8 columns.
    // NOLINTBEGIN(performance-unnecessary-copy-initialization)
    const Lane xa = x[at], xb = x[at + 1], xc = x[at + 2];
    Lane ya = a[0] * xa + a[1] * xb + a[2] * xc, yb = a[1] * xa + b[1] * xb + b[2] * xc,
         yc = a[2] * xa + b[2] * xb + c[2] * xc;
    for (int e = 3; e < length; e += 3) {
        const auto i = static_cast<std::size_t>(rows[e]);
        for (int r = 0; r < 3; ++r) {
            const Lane xi = x[i + static_cast<std::size_t>(r)];
            ya += a[e + r] * xi;
            yb += b[e + r] * xi;
            yc += c[e + r] * xi;
            y[i + static_cast<std::size_t>(r)] += a[e + r] * xa + b[e + r] * xb + c[e + r] * xc;
        }
    }
    // NOLINTEND(performance-unnecessary-copy-initialization)
    y[at] += ya;
    y[at + 1] += yb;
    y[at + 2] += yc;
}

/// Columns first ... first + count - 1 of Y = A X, count <= K. The K numbers of a row are interleaved, so that the
/// matrix is read once for K columns.
template <int K>
void product_of(const SymmetricSparse& lower, bool in_threes, const MatrixXd& X, Eigen::Index first, Eigen::Index count,
                MatrixXd& Y) {
    using Lane = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, K>>;
    const auto n = static_cast<std::size_t>(X.rows());
    std::vector<Lane> x(n), y(n, Lane(0.0));
    auto* numbers = reinterpret_cast<double*>(x.data());
    for (Eigen::Index k = 0; k < K; ++k)
        for (std::size_t i = 0; i < n; ++i)
            numbers[i * K + static_cast<std::size_t>(k)] = k < count ? X(static_cast<Eigen::Index>(i), first + k) : 0.0;
    const int* start = lower.outerIndexPtr();
    const int* rows = lower.innerIndexPtr();
    const double* values = lower.valuePtr();
    if (in_threes)
        for (int j = 0; j < lower.outerSize(); j += 3) add_block_column(lower, j, x, y);
    // General pattern: each off-diagonal entry acts on both its row and its column.
    for (std::size_t j = 0; j < n && !in_threes; ++j) {
        Lane sum = 0.0;
        const Lane xj = x[j];
        int entry = start[j];
        if (entry < start[j + 1] && rows[entry] == static_cast<int>(j)) sum += values[entry++] * xj;
        for (; entry < start[j + 1]; ++entry) {
            const auto i = static_cast<std::size_t>(rows[entry]);
            sum += values[entry] * x[i];
            y[i] += values[entry] * xj;
        }
        y[j] += sum;
    }
    numbers = reinterpret_cast<double*>(y.data());
    for (Eigen::Index k = 0; k < count; ++k)
        for (std::size_t i = 0; i < n; ++i)
            Y(static_cast<Eigen::Index>(i), first + k) = numbers[i * K + static_cast<std::size_t>(k)];
}

}  // namespace

ConjugateGradientReport conjugate_gradient(const LinearOperator& A, const LinearOperator& preconditioner,
                                           const MatrixXd& B, double tolerance, int max_iterations,
                                           const MatrixXd& guess) {
    ConjugateGradientReport report;
    MatrixXd& X = report.solution;
    X = guess.size() == 0 ? MatrixXd::Zero(B.rows(), B.cols()) : guess;
    const RowVectorXd scale = B.colwise().norm();
    // A zero right-hand side has the exact solution 0, and its relative residual is undefined.
    for (Eigen::Index k = 0; k < B.cols(); ++k)
        if (scale(k) == 0.0) X.col(k).setZero();
    MatrixXd R = B;
    if (guess.size() > 0) R -= A(X);
    using Flags = Eigen::Array<bool, 1, Eigen::Dynamic>;
    Flags open;                // columns above the tolerance
    const auto look = [&]() {  // updates `open`; false once all columns have converged
        const RowVectorXd size = R.colwise().norm();
        open = size.array() > tolerance * scale.array();
        report.relative_residual = (scale.array() > 0.0).select(size.array() / scale.array(), 0.0).maxCoeff();
        return open.any();
    };
    if (!look()) {
        report.converged = true;
        return report;
    }
    MatrixXd Z = preconditioner(R);
    MatrixXd P = Z;
    RowVectorXd rz = column_dots(R, Z);
    while (report.iterations < max_iterations && !cancellation_requested()) {
        const MatrixXd AP = A(P);
        const RowVectorXd curvature = column_dots(P, AP);
        ++report.iterations;
        // Converged columns are frozen: further iterations only add rounding, and their curvature may vanish.
        for (Eigen::Index k = 0; k < B.cols(); ++k) {
            if (!open(k)) continue;
            if (!(curvature(k) > 0.0)) {
                report.negative_curvature = true;
                return report;
            }
            const double alpha = rz(k) / curvature(k);
            X.col(k) += alpha * P.col(k);
            R.col(k) -= alpha * AP.col(k);
        }
        if (!look()) {
            report.converged = true;
            return report;
        }
        Z = preconditioner(R);
        const RowVectorXd rz_next = column_dots(R, Z);
        for (Eigen::Index k = 0; k < B.cols(); ++k)
            if (rz(k) != 0.0) P.col(k) = Z.col(k) + rz_next(k) / rz(k) * P.col(k);
        rz = rz_next;
    }
    return report;
}

MatrixXd symmetric_product(const SymmetricSparse& lower, const MatrixXd& X) {
    MatrixXd Y(X.rows(), X.cols());
    // Groups of 16 columns fill the registers; the remainder uses the smallest sufficient width.
    const Eigen::Index columns = X.cols();
    const int groups = static_cast<int>((columns + conjugate_gradient_policy.wide - 1) /
                                        conjugate_gradient_policy.wide);
    const bool in_threes = has_blocks_of_three(lower);
    parallel_ranges(groups, 1, [&](int begin, int end) {
        for (Eigen::Index first = begin * conjugate_gradient_policy.wide;
             first < std::min<Eigen::Index>(end * conjugate_gradient_policy.wide, columns);
             first += conjugate_gradient_policy.wide) {
            const Eigen::Index count = std::min<Eigen::Index>(conjugate_gradient_policy.wide, columns - first);
            if (count == 1)
                product_of<1>(lower, in_threes, X, first, count, Y);
            else if (count <= 4)
                product_of<4>(lower, in_threes, X, first, count, Y);
            else if (count <= 8)
                product_of<8>(lower, in_threes, X, first, count, Y);
            else
                product_of<conjugate_gradient_policy.wide>(lower, in_threes, X, first, count, Y);
        }
    });
    return Y;
}

}  // namespace myo::solver
