#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "solver/fast_cholesky.hpp"
#include "solver/schwarz.hpp"
#include "support/dense.hpp"
#include "support/matrices.hpp"

// The pattern of a factor, its numbers for every size of block, and what is no positive definite matrix.

namespace myo::solver::supernodal_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Lower triangle of A A' + n I with a random A: one dense block.
SymmetricSparse dense_matrix(int n) {
    std::srand(static_cast<unsigned>(n));
    const MatrixXd A = MatrixXd::Random(n, n), full = A * A.transpose() + 0.5 * MatrixXd::Identity(n, n);
    SymmetricSparse lower(n, n);
    for (int j = 0; j < n; ++j)
        for (int i = j; i < n; ++i) lower.insert(i, j) = full(i, j);
    lower.makeCompressed();
    return lower;
}

MatrixXd full_of(const SymmetricSparse& lower) { return MatrixXd(lower).selfadjointView<Eigen::Lower>(); }

TEST(SupernodalPattern, IsATreeWhoseRowsStandInTheirParents) {
    for (const SymmetricSparse& lower :
         {test::random_matrix(1, 3, 1.0), test::random_matrix(90, 3, 1.0), test::laplacian(9, 8, 7, 0.1)}) {
        const SupernodalPattern p = analyse_pattern(lower);
        ASSERT_EQ(p.size(), lower.rows());
        EXPECT_EQ(std::set<int>(p.permutation.begin(), p.permutation.end()).size(), at(p.size()));
        EXPECT_EQ(p.first_column.front(), 0);
        EXPECT_EQ(p.first_column.back(), p.size());
        int roots = 0, children = 0;
        for (int s = 0; s < p.supernodes(); ++s) {
            const int* const rows = p.rows.data() + p.first_row[at(s)];
            EXPECT_GT(p.columns(s), 0);
            EXPECT_GE(p.row_stride(s), p.row_count(s));
            EXPECT_EQ(p.row_stride(s) % SupernodalPattern::stride_unit, 0);
            for (int c = 0; c < p.columns(s); ++c) EXPECT_EQ(rows[c], p.first_column[at(s)] + c) << "own columns first";
            for (int r = 1; r < p.row_count(s); ++r) EXPECT_LT(rows[r - 1], rows[r]);
            children += static_cast<int>(p.children[at(s)].size());
            for (const int child : p.children[at(s)]) EXPECT_EQ(p.parent[at(child)], s);
            const int up = p.parent[at(s)];
            if (up < 0) {
                ++roots;
                EXPECT_EQ(p.row_count(s), p.columns(s)) << "a root has no rows below";
                continue;
            }
            EXPECT_GT(up, s);
            for (int r = p.columns(s); r < p.row_count(s); ++r) {
                const long position = p.parent_position[static_cast<std::size_t>(p.first_row[at(s)]) + at(r)];
                EXPECT_EQ(p.rows[static_cast<std::size_t>(p.first_row[at(up)] + position)], rows[r]);
            }
            // What runs on one thread is a whole subtree, within that of its parent if that has one.
            if (p.subtree_start[at(s)] < 0) {
                EXPECT_LT(p.subtree_start[at(up)], 0);
            } else if (p.subtree_start[at(up)] >= 0) {
                EXPECT_LE(p.subtree_start[at(up)], p.subtree_start[at(s)]);
            }
        }
        EXPECT_EQ(roots, static_cast<int>(p.roots.size()));
        EXPECT_EQ(children + roots, p.supernodes());
        const std::set<std::uint32_t> places(p.entry.begin(), p.entry.end());
        EXPECT_EQ(places.size(), static_cast<std::size_t>(lower.nonZeros())) << "each entry has a place of its own";
        EXPECT_LT(static_cast<long>(*places.rbegin()), p.value_count());
    }
}

/// A dense block of n columns costs n^3 / 3; the cost of a chain grows with its length.
TEST(SupernodalPattern, CountsOperations) {
    for (const int n : {1, 5, 16, 17, 40}) {
        const SupernodalPattern p = analyse_pattern(dense_matrix(n));
        EXPECT_EQ(p.supernodes(), 1);
        EXPECT_NEAR(factor_flops(p), std::pow(n, 3) / 3.0, 1e-9 * std::pow(n, 3));
        EXPECT_EQ(p.value_count(), n * ((n + 15) / 16 * 16));
    }
    const double one = factor_flops(analyse_pattern(test::laplacian(200, 1, 1, 0.0))),
                 two = factor_flops(analyse_pattern(test::laplacian(400, 1, 1, 0.0)));
    EXPECT_NEAR(two / one, 2.0, 0.5) << "with a full factor it would be 8";
}

/// Around the blocks of 8 rows and columns, and around the groups of 1, 4, 8 and 16 right-hand sides.
TEST(SupernodalFactor, SolvesBlocksAndGroupsOfEverySize) {
    for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 15, 16, 17, 18, 23, 24, 25, 32, 33}) {
        const SymmetricSparse lower = dense_matrix(n);
        const MatrixXd A = full_of(lower);
        const SupernodalPattern pattern = analyse_pattern(lower);
        SupernodalFactor<double> factor;
        ASSERT_TRUE(factorize(pattern, lower, factor));
        for (const int columns : {1, 2, 4, 5, 8, 9, 16, 17, 21, 33}) {
            const MatrixXd exact = MatrixXd::Random(n, columns);
            EXPECT_LT((solve(pattern, factor, A * exact) - exact).norm(), 1e-9 * exact.norm()) << n << " " << columns;
        }
        EXPECT_EQ(solve(pattern, factor, MatrixXd(n, 0)).cols(), 0);
    }
}

/// Powers of two on rows and columns leave every digit, since the factor is that of the matrix with a unit diagonal.
TEST(SupernodalFactor, ScalesOfUnknownsChangeNoDigit) {
    const SymmetricSparse lower = test::random_matrix(60, 4, 1.0);
    VectorXd scale(60);
    for (int i = 0; i < 60; ++i) scale(i) = std::ldexp(1.0, 7 * (i % 9) - 20);
    const SymmetricSparse scaled = scale.asDiagonal() * lower * scale.asDiagonal();
    const MatrixXd B = MatrixXd::Random(60, 5);
    FastCholesky plain, other;
    ASSERT_TRUE(plain.factorize(lower));
    ASSERT_TRUE(other.factorize(scaled));
    EXPECT_EQ(MatrixXd(scale.asDiagonal() * other.solve(scale.asDiagonal() * B)), plain.solve(B));
}

/// One entry spoils each of these; the factor is empty then, and the next matrix finds it usable.
TEST(SupernodalFactor, RefusesWhatIsNotPositiveDefinite) {
    const double none = std::nan(""), infinite = std::numeric_limits<double>::infinity();
    for (const SymmetricSparse& good : {dense_matrix(20), test::laplacian(6, 5, 4, 0.1)}) {
        const int last = static_cast<int>(good.cols()) - 1;
        const std::vector<std::pair<int, int>> places{{0, 0}, {7, 7}, {last, last}, {1, 0}, {last, last - 1}};
        FastCholesky fast;
        SupernodalFactor<double> exact;
        const SupernodalPattern pattern = analyse_pattern(good);
        for (const auto& [row, column] : places)
            for (const double value : {none, infinite, -infinite, row == column ? 0.0 : 1e6}) {
                SymmetricSparse bad = good;
                bad.coeffRef(row, column) = value;
                EXPECT_FALSE(fast.factorize(bad)) << row << " " << column << " " << value;
                EXPECT_FALSE(fast.has_factor());
                EXPECT_FALSE(factorize(pattern, bad, exact)) << row << " " << column << " " << value;
                EXPECT_TRUE(exact.empty());
            }
        ASSERT_TRUE(fast.factorize(good));
        EXPECT_TRUE(fast.solve(MatrixXd::Ones(good.rows(), 1)).allFinite());
    }
    SymmetricSparse hollow(3, 3);  // no diagonal is stored
    hollow.insert(1, 0) = 1.0;
    hollow.insert(2, 1) = 1.0;
    hollow.makeCompressed();
    EXPECT_FALSE(FastCholesky().factorize(hollow));
}

TEST(FastCholeskySize, IsKnownFromTheAnalysis) {
    FastCholesky fast;
    EXPECT_EQ(fast.factor_entries(), 0.0);
    EXPECT_EQ(fast.factor_flops(), 0.0);
    const SymmetricSparse lower = test::laplacian(8, 7, 6, 0.1);
    fast.analyse(lower);
    EXPECT_FALSE(fast.has_factor());
    const double entries = fast.factor_entries(), flops = fast.factor_flops();
    EXPECT_GE(entries, static_cast<double>(lower.nonZeros()));
    EXPECT_GT(flops, entries);
    ASSERT_TRUE(fast.factorize(lower));
    EXPECT_EQ(fast.factor_entries(), entries);
    EXPECT_EQ(fast.factor_flops(), flops);
    const FastCholesky copy = fast;
    const MatrixXd B = MatrixXd::Random(lower.rows(), 3), X = fast.solve(B);
    ASSERT_TRUE(fast.factorize(4.0 * lower));
    EXPECT_EQ(copy.solve(B), X) << "a copy has numbers of its own";
    EXPECT_EQ(MatrixXd(4.0 * fast.solve(B)), X) << "the scaling takes out a factor of four without a digit";
}

/// A body of one part: the inverse itself, and the coarse problem on top of it.
TEST(SchwarzOfOnePart, IsTheInversePlusTheCoarseInverse) {
    SymmetricSparse lower = dense_matrix(30);
    const MatrixXd A = full_of(lower), Z = MatrixXd::Random(30, 4), B = MatrixXd::Random(30, 2);
    SchwarzPreconditioner parts;
    EXPECT_EQ(parts.factor_entries(), 0.0);
    ASSERT_TRUE(parts.factorize(lower, Z));
    const MatrixXd coarse = Z * test::inverse(Z.transpose() * A * Z) * Z.transpose() * B,
                   expected = test::inverse(A) * B + coarse;
    EXPECT_LT((parts.solve(B) - expected).norm(), 1e-3 * expected.norm());
    EXPECT_GT(coarse.norm(), 1e-3 * expected.norm()) << "or the coarse part would not be seen";
    FastCholesky whole;
    ASSERT_TRUE(whole.factorize(lower));
    EXPECT_LT((parts.solve(B) - whole.solve(B) - coarse).norm(), 1e-10 * coarse.norm()) << "the same single precision";
    EXPECT_EQ(parts.factor_entries(), whole.factor_entries());
    EXPECT_EQ(parts.factor_flops(), whole.factor_flops());
    // New numbers with the known pattern, then another size.
    const MatrixXd before = parts.solve(B);
    lower.coeffs() *= 4.0;
    ASSERT_TRUE(parts.factorize(lower, Z));
    EXPECT_LT((4.0 * parts.solve(B) - before).norm(), 1e-12 * before.norm());
    ASSERT_TRUE(parts.factorize(dense_matrix(12), MatrixXd::Random(12, 2)));
    EXPECT_EQ(parts.solve(MatrixXd::Ones(12, 1)).rows(), 12);
}

}  // namespace
}  // namespace myo::solver::supernodal_test
