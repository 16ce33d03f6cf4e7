#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <random>

#include "solver/conjugate_gradient.hpp"

namespace myo::solver {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const LinearOperator nothing = [](const MatrixXd& V) { return V; };

MatrixXd spd(int n) {
    std::srand(9);
    const MatrixXd A = MatrixXd::Random(n, n);
    return A * A.transpose() + MatrixXd::Identity(n, n);
}

LinearOperator product(const MatrixXd& A) {
    return [&A](const MatrixXd& V) { return MatrixXd(A * V); };
}

TEST(ConjugateGradient, IsExactInAsManyStepsAsUnknowns) {
    for (const int n : {1, 2, 5, 12}) {
        const MatrixXd A = spd(n);
        const VectorXd b = VectorXd::LinSpaced(n, 1.0, 2.0);
        const ConjugateGradientReport report = conjugate_gradient(product(A), nothing, b, 1e-9, n);
        EXPECT_TRUE(report.converged) << n;
        EXPECT_LE(report.iterations, n);
        EXPECT_LT((A * report.solution - b).norm(), 2e-9 * b.norm());
    }
}

TEST(ConjugateGradient, NeedsOneStepPerDistinctEigenvalueAndOneWithTheInverse) {
    const VectorXd d = (VectorXd(9) << 1, 1, 1, 4, 4, 4, 9, 9, 9).finished();
    const MatrixXd A = d.asDiagonal();
    const VectorXd b = VectorXd::Ones(9);
    EXPECT_EQ(conjugate_gradient(product(A), nothing, b, 1e-12, 50).iterations, 3);
    const LinearOperator inverse = [&](const MatrixXd& V) { return MatrixXd(d.cwiseInverse().asDiagonal() * V); };
    EXPECT_EQ(conjugate_gradient(product(A), inverse, b, 1e-12, 50).iterations, 1);
}

TEST(ConjugateGradient, ReportsNegativeCurvatureAndTheIterationLimit) {
    MatrixXd A = spd(6);
    A(3, 3) = -50.0;
    const ConjugateGradientReport indefinite = conjugate_gradient(product(A), nothing, VectorXd::Unit(6, 3), 1e-12, 50);
    EXPECT_TRUE(indefinite.negative_curvature);
    EXPECT_FALSE(indefinite.converged);
    EXPECT_TRUE(indefinite.solution.allFinite());

    const MatrixXd B = spd(10);
    const ConjugateGradientReport limited = conjugate_gradient(product(B), nothing, VectorXd::Ones(10), 1e-14, 2);
    EXPECT_FALSE(limited.converged);
    EXPECT_FALSE(limited.negative_curvature);
    EXPECT_EQ(limited.iterations, 2);
    EXPECT_NEAR(limited.relative_residual, (B * limited.solution - VectorXd::Ones(10)).norm() / std::sqrt(10.0), 1e-12);
}

/// Columns run side by side as they do alone; a good guess saves iterations.
TEST(ConjugateGradient, SolvesColumnsSideBySideAndStartsFromAGuess) {
    const MatrixXd A = spd(12);
    MatrixXd B = MatrixXd::Random(12, 4);
    B.col(2).setZero();
    const ConjugateGradientReport together = conjugate_gradient(product(A), nothing, B, 1e-10, 100);
    ASSERT_TRUE(together.converged);
    EXPECT_LT((A * together.solution - B).norm(), 1e-9 * B.norm());
    for (int k = 0; k < 4; ++k) {
        const ConjugateGradientReport alone = conjugate_gradient(product(A), nothing, B.col(k), 1e-10, 100);
        EXPECT_LT((together.solution.col(k) - alone.solution).norm(), 1e-7 * (1.0 + alone.solution.norm())) << k;
        EXPECT_LE(alone.iterations, together.iterations);
    }
    const ConjugateGradientReport guessed = conjugate_gradient(product(A), nothing, B, 1e-10, 100,
                                                               together.solution + MatrixXd::Constant(12, 4, 1e-7));
    EXPECT_TRUE(guessed.converged);
    EXPECT_LT(guessed.iterations, together.iterations);
    EXPECT_LT((A * guessed.solution - B).norm(), 1e-9 * B.norm());
}

TEST(SymmetricProduct, IsTheFullMatrixTimesTheColumns) {
    const MatrixXd A = spd(9);
    const SymmetricSparse lower = MatrixXd(A.triangularView<Eigen::Lower>()).sparseView();
    for (const int columns : {1, 2, 3, 4, 7}) {
        const MatrixXd X = MatrixXd::Random(9, columns);
        EXPECT_LT((symmetric_product(lower, X) - A * X).norm(), 1e-13 * (A * X).norm()) << columns;
    }
}

TEST(ConjugateGradient, ZeroRightHandSideIsDoneAtOnce) {
    const MatrixXd A = spd(4);
    const ConjugateGradientReport report = conjugate_gradient(product(A), nothing, VectorXd::Zero(4), 1e-10, 10);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_TRUE(report.solution.isZero(0.0));
}

/// With and without the blocks of three that the coordinates of nodes make, for every number of columns side by side.
TEST(SymmetricProduct, EqualsTheDenseOne) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    for (const bool blocks : {true, false}) {
        const int n = 24;
        SymmetricSparse lower(n, n);
        for (int j = 0; j < n; ++j)
            for (int i = j; i < n; ++i) {
                const bool kept = (i / 3 + 2 * (j / 3)) % 3 == 0 || i / 3 == j / 3;
                if (kept && (blocks || (i + j) % 5 != 1)) lower.insert(i, j) = value(random);
            }
        lower.makeCompressed();
        const MatrixXd full = MatrixXd(lower).selfadjointView<Eigen::Lower>();
        for (const int columns : {1, 3, 7, 16, 37}) {
            const MatrixXd X = MatrixXd::NullaryExpr(n, columns, [&] { return value(random); });
            EXPECT_LT((symmetric_product(lower, X) - full * X).norm(), 1e-14 * full.norm() * X.norm())
                << blocks << ' ' << columns;
        }
    }
}

}  // namespace
}  // namespace myo::solver
