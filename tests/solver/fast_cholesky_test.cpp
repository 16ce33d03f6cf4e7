#include "solver/fast_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <atomic>
#include <cmath>
#include <thread>

#include "base/abandonable.hpp"
#include "base/cancellation.hpp"
#include "base/parallel.hpp"
#include "support/matrices.hpp"

namespace myo::solver {
namespace {

using Eigen::MatrixXd;
using test::laplacian;
using test::random_matrix;

double residual(const SymmetricSparse& H, const MatrixXd& X, const MatrixXd& B) {
    return (H.selfadjointView<Eigen::Lower>() * X - B).norm() / B.norm();
}

/// Our factor in double precision against CHOLMOD's, on matrices without structure and on one with a bushy tree.
TEST(SupernodalFactor, SolvesAsCholmodDoes) {
    for (const SymmetricSparse& H : {random_matrix(1, 7, 0.5), random_matrix(400, 7, 0.5), laplacian(17, 14, 11, 0.01),
                                     laplacian(300, 3, 3, 0.0)}) {
        std::srand(6);
        const MatrixXd B = MatrixXd::Random(H.rows(), 20);
        const SupernodalPattern pattern = analyse_pattern(H);
        SupernodalFactor<double> factor;
        ASSERT_TRUE(factorize(pattern, H, factor));
        SparseCholesky other;
        ASSERT_TRUE(other.factorize(H));
        const MatrixXd X = solve(pattern, factor, B), Y = other.solve(B);
        EXPECT_LT((X - Y).norm(), 1e-10 * Y.norm());
        EXPECT_LT((solve(pattern, factor, B.col(3)) - X.col(3)).norm(), 1e-12 * X.col(3).norm());
    }
}

/// Sums are taken along the tree, whoever does the work.
TEST(SupernodalFactor, HasTheSameBitsOnAnyNumberOfThreads) {
    const SymmetricSparse H = laplacian(20, 18, 16, 0.1);
    std::srand(8);
    const MatrixXd B = MatrixXd::Random(H.rows(), 3);
    const auto solution_on = [&](int threads) {
        MatrixXd X;
        parallel_tasks(1, threads, [&](int) {
            FastCholesky factor;
            ASSERT_TRUE(factor.factorize(H));
            X = factor.solve(B);
        });
        return X;
    };
    const MatrixXd one = solution_on(1);
    for (const int threads : {2, 4, 8}) EXPECT_TRUE((solution_on(threads).array() == one.array()).all()) << threads;
}

/// A cancelled task gets no factor, at the analysis or at the numbers, and the same object works afterwards.
TEST(FastCholesky, GivesUpWhereItsTaskIsCancelled) {
    const SymmetricSparse H = laplacian(20, 18, 16, 0.1);
    std::atomic<bool> stop{true};
    const Progress progress({}, &stop);
    FastCholesky factor;
    {
        const CancellationScope scope(&progress);
        EXPECT_FALSE(factor.factorize(H)) << "the analysis is abandoned";
        stop = false;
        EXPECT_TRUE(factor.factorize(H));
        stop = true;
        EXPECT_FALSE(factor.factorize(H)) << "the analysis is known; the numbers are left";
    }
    EXPECT_TRUE(factor.factorize(H));
    std::srand(8);
    const MatrixXd B = MatrixXd::Random(H.rows(), 2);
    EXPECT_LT(residual(H, factor.solve(B), B), 1e-5);
    while (abandoned_calls() > 0) std::this_thread::yield();
}

/// Single precision solves to its precision, for one and for several columns, of any size of numbers.
TEST(FastCholesky, SolvesToItsPrecision) {
    for (const int n : {1, 2, 30, 400}) {
        const SymmetricSparse H = random_matrix(n, 13, 4.0);
        std::srand(5);
        MatrixXd B = MatrixXd::Random(n, 5);
        B.col(1) *= 1e60;  // beyond the range of single precision
        B.col(2) *= 1e-60;
        B.col(3).setZero();
        FastCholesky factor;
        EXPECT_FALSE(factor.has_factor());
        ASSERT_TRUE(factor.factorize(H));
        SparseCholesky reference;
        ASSERT_TRUE(reference.factorize(H));
        const MatrixXd exact = reference.solve(B), X = factor.solve(B);
        for (int k = 0; k < 5; ++k) {
            EXPECT_LE((X.col(k) - exact.col(k)).norm(), 1e-4 * exact.col(k).norm()) << n << " column " << k;
            EXPECT_LE((factor.solve(B.col(k)) - exact.col(k)).norm(), 1e-4 * exact.col(k).norm())
                << n << " column " << k << " alone";
        }
        EXPECT_GE(factor.factor_entries(), static_cast<double>(n));
    }
}

TEST(FastCholesky, NewValuesReuseThePatternAndAnotherSizeIsAnalysedAnew) {
    FastCholesky factor;
    SymmetricSparse H = random_matrix(60, 1, 1.0);
    ASSERT_TRUE(factor.factorize(H));
    const MatrixXd b = MatrixXd::Ones(60, 1);
    const MatrixXd x = factor.solve(b);
    H.coeffs() *= 4.0;
    ASSERT_TRUE(factor.factorize(H));
    EXPECT_LT((4.0 * factor.solve(b) - x).norm(), 1e-5 * x.norm());
    const SymmetricSparse other = random_matrix(25, 2, 1.0);
    ASSERT_TRUE(factor.factorize(other));
    EXPECT_LT(residual(other, factor.solve(MatrixXd::Ones(25, 1)), MatrixXd::Ones(25, 1)), 1e-4);
}

TEST(FastCholesky, IndefiniteMatricesAreToldAndTheFactorRecovers) {
    const SymmetricSparse H = random_matrix(80, 5, 0.1);
    FastCholesky factor;
    ASSERT_TRUE(factor.factorize(H));
    SymmetricSparse indefinite = H;
    indefinite.coeffRef(40, 40) = -1.0;
    EXPECT_FALSE(factor.factorize(indefinite));
    EXPECT_FALSE(factor.has_factor());
    SymmetricSparse hidden = laplacian(6, 6, 6, -2.0);  // a positive diagonal, but indefinite
    EXPECT_FALSE(factor.factorize(hidden));
    ASSERT_TRUE(factor.factorize(H));
    EXPECT_LT(residual(H, factor.solve(MatrixXd::Ones(80, 1)), MatrixXd::Ones(80, 1)), 1e-2);
}

/// Entries that differ by many orders between unknowns, as of stiff and soft parts, are taken out by the scaling.
TEST(FastCholesky, StiffnessContrastCostsNoDigits) {
    SymmetricSparse H = laplacian(8, 8, 8, 0.5);
    const Eigen::VectorXd size = Eigen::VectorXd::NullaryExpr(
        H.rows(), [](Eigen::Index i) { return std::pow(10.0, static_cast<double>(i % 9)); });
    H = SymmetricSparse(size.asDiagonal() * H * size.asDiagonal());
    const Eigen::VectorXd x = Eigen::VectorXd::Ones(H.rows()),
                          b = H.selfadjointView<Eigen::Lower>() * size.cwiseInverse();
    FastCholesky factor;
    ASSERT_TRUE(factor.factorize(H));
    EXPECT_LT((size.cwiseProduct(factor.solve(b)) - x).norm(), 1e-5 * x.norm());
}

/// Too close to singular for single precision: the factor comes from double then.
TEST(FastCholesky, TakesDoublePrecisionWhereSingleBreaksDown) {
    int broken = 0;
    for (int n = 40; n < 60; ++n) {
        const double smallest = 2.0 - 2.0 * std::cos(M_PI / (n + 1));  // eigenvalue of the chain of n nodes
        const SymmetricSparse H = laplacian(n, 1, 1, -4.0 - smallest + 1e-9);
        SupernodalFactor<float> single;
        broken += factorize(analyse_pattern(H), H, single) ? 0 : 1;
        FastCholesky factor;
        EXPECT_TRUE(factor.factorize(H)) << n;
    }
    EXPECT_GT(broken, 0);
}

TEST(FastCholesky, SamePatternWithOtherPlacesOfTheEntriesIsNotMistaken) {
    SymmetricSparse diagonal(3, 3), full(3, 3);
    diagonal.setIdentity();
    full = MatrixXd(Eigen::Matrix3d{{4, 0, 0}, {1, 5, 0}, {2, 1, 6}}).sparseView();
    diagonal.makeCompressed();
    full.makeCompressed();
    FastCholesky factor;
    ASSERT_TRUE(factor.factorize(diagonal));
    ASSERT_TRUE(factor.factorize(full));
    EXPECT_LT(residual(full, factor.solve(MatrixXd::Ones(3, 1)), MatrixXd::Ones(3, 1)), 1e-6);
}

}  // namespace
}  // namespace myo::solver
