#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <atomic>
#include <cmath>

#include "base/cancellation.hpp"
#include "solver/conjugate_gradient.hpp"
#include "solver/gmres.hpp"
#include "support/matrices.hpp"

// Iterative solvers at the ends of their rules: guesses, tolerances, restarts, singular and non-finite systems.

namespace myo::solver::iterations_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const LinearOperator same = [](const MatrixXd& V) { return V; };
const VectorProduct same_vector = [](const VectorXd& V) { return V; };

/// The second difference of a chain: symmetric positive definite with known eigenvalues 2 - 2 cos(k pi / (n + 1)).
MatrixXd chain(Eigen::Index n) {
    MatrixXd A = 2.0 * MatrixXd::Identity(n, n);
    A.diagonal(1).setConstant(-1.0);
    A.diagonal(-1).setConstant(-1.0);
    return A;
}

LinearOperator times(const MatrixXd& A) {
    return [A](const MatrixXd& V) { return MatrixXd(A * V); };
}
VectorProduct times_vector(const MatrixXd& A) {
    return [A](const VectorXd& V) { return VectorXd(A * V); };
}

/// The error in the energy norm falls by 2 ((sqrt c - 1)/(sqrt c + 1))^k at least, and never grows.
/// Source: Nocedal & Wright 2006, eq. 5.36.
TEST(Iterations, ErrorInTheEnergyNormFallsAsTheConditionNumberPromises) {
    const Eigen::Index n = 40;
    const MatrixXd A = chain(n);
    const double smallest = 2.0 - 2.0 * std::cos(M_PI / 41.0), largest = 2.0 - 2.0 * std::cos(40.0 * M_PI / 41.0),
                 root = std::sqrt(largest / smallest), rate = (root - 1.0) / (root + 1.0);
    const VectorXd exact = VectorXd::LinSpaced(n, -1.0, 2.0).array().sin(), b = A * exact;
    const double at_start = std::sqrt(exact.dot(A * exact));
    double before = at_start;
    for (int most = 1; most <= 40; ++most) {
        const VectorXd error = conjugate_gradient(times(A), same, b, 0.0, most).solution.col(0) - exact;
        const double now = std::sqrt(std::abs(error.dot(A * error)));
        EXPECT_LE(now, before * (1.0 + 1e-9) + 1e-12) << most;
        EXPECT_LE(now, 2.0 * std::pow(rate, most) * at_start + 1e-12) << most;
        before = now;
    }
    EXPECT_LT(before, 1e-10 * at_start) << "exact after as many steps as unknowns";
}

TEST(Iterations, GuessesCountAndExactOnesCostNothing) {
    const MatrixXd A = chain(12), exact = MatrixXd::Random(12, 3), B = A * exact;
    const ConjugateGradientReport done = conjugate_gradient(times(A), same, B, 1e-12, 50, exact);
    EXPECT_TRUE(done.converged);
    EXPECT_EQ(done.iterations, 0);
    EXPECT_EQ(done.solution, exact);
    EXPECT_LT(done.relative_residual, 1e-12);
    // A column that is solved already stays as it is while the others go on.
    MatrixXd guess = MatrixXd::Zero(12, 3);
    guess.col(1) = exact.col(1);
    const ConjugateGradientReport mixed = conjugate_gradient(times(A), same, B, 1e-11, 50, guess);
    EXPECT_TRUE(mixed.converged);
    EXPECT_EQ(mixed.solution.col(1), exact.col(1));
    EXPECT_LT((mixed.solution - exact).norm(), 1e-9);
    // A zero right-hand side has the solution 0, whatever was guessed.
    MatrixXd with_zero = B;
    with_zero.col(0).setZero();
    const ConjugateGradientReport zero = conjugate_gradient(times(A), same, with_zero, 1e-10, 50, exact);
    EXPECT_TRUE(zero.converged);
    EXPECT_TRUE(zero.solution.col(0).isZero(0.0));
    EXPECT_EQ(zero.iterations, 0);
}

/// The tolerance is relative to each column: powers of two near 1e-138 and 1e138 as factors change no digit.
TEST(Iterations, ColumnsOfAnyScaleConvergeAlike) {
    const MatrixXd A = chain(15);
    const VectorXd b = VectorXd::LinSpaced(15, 1.0, 3.0);
    const int alone = conjugate_gradient(times(A), same, b, 1e-9, 50).iterations;
    const double tiny = std::ldexp(1.0, -460), huge = std::ldexp(1.0, 460);
    MatrixXd B(15, 3);
    B << b, tiny * b, huge * b;
    const ConjugateGradientReport report = conjugate_gradient(times(A), same, B, 1e-9, 50);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, alone);
    EXPECT_LE(report.relative_residual, 1e-9);
    EXPECT_LT((huge * report.solution.col(1) - report.solution.col(0)).norm(), 1e-12 * report.solution.col(0).norm());
    EXPECT_LT((tiny * report.solution.col(2) - report.solution.col(0)).norm(), 1e-12 * report.solution.col(0).norm());
}

TEST(Iterations, SingularNonFiniteAndCancelledSystemsEndWithoutASolution) {
    const VectorXd b = VectorXd::Ones(5);
    const ConjugateGradientReport flat = conjugate_gradient(times(MatrixXd::Zero(5, 5)), same, b, 1e-9, 50);
    EXPECT_TRUE(flat.negative_curvature) << "a curvature of 0 is none";
    EXPECT_FALSE(flat.converged);
    EXPECT_EQ(flat.iterations, 1);
    EXPECT_EQ(flat.relative_residual, 1.0);
    EXPECT_TRUE(flat.solution.isZero(0.0)) << "the last iterate";
    const MatrixXd broken = MatrixXd::Constant(5, 5, std::nan(""));
    EXPECT_FALSE(conjugate_gradient(times(broken), same, b, 1e-9, 50).converged);
    EXPECT_FALSE(gmres(times_vector(broken), same_vector, b, 1e-9, 50).converged);
    EXPECT_LE(gmres(times_vector(broken), same_vector, b, 1e-9, 50).iterations, 1);
    EXPECT_FALSE(gmres(times_vector(MatrixXd::Zero(5, 5)), same_vector, b, 1e-9, 50).converged);
    std::atomic<bool> stop{true};
    const Progress progress({}, &stop);
    const CancellationScope scope(&progress);
    const ConjugateGradientReport cancelled = conjugate_gradient(times(chain(5)), same, b, 1e-9, 50);
    EXPECT_FALSE(cancelled.converged);
    EXPECT_FALSE(cancelled.negative_curvature) << "a cancelled task says nothing of the matrix";
    EXPECT_EQ(cancelled.iterations, 0);
}

/// Residuals of successive numbers of steps never grow, since each minimises over a larger space.
TEST(Iterations, MinimalResidualsFallWithEveryStepAndAcrossRestarts) {
    const Eigen::Index n = 70;
    MatrixXd A = chain(n) + 0.05 * MatrixXd::Identity(n, n);
    A.diagonal(1) *= 0.3;  // far from symmetric
    const VectorXd b = VectorXd::LinSpaced(n, 1.0, 2.0);
    double before = b.norm();
    for (const int most : {1, 2, 3, 10, 39, 40, 41, 60}) {
        const GmresReport report = gmres(times_vector(A), same_vector, b, 1e-13, most);
        const double now = (b - A * report.solution).norm();
        EXPECT_LE(now, before * (1.0 + 1e-9) + 1e-12) << most;
        EXPECT_LE(report.iterations, most);
        before = now;
    }
    // The first step is the best multiple of b: the residual is orthogonal to A b.
    const VectorXd first = b - A * gmres(times_vector(A), same_vector, b, 1e-13, 1).solution;
    EXPECT_NEAR(first.dot(A * b), 0.0, 1e-10 * b.squaredNorm());
}

/// A turn by a quarter has no symmetric part: conjugate gradients see no curvature, minimal residuals need two steps.
TEST(Iterations, ARotationIsSolvedInTwoSteps) {
    MatrixXd A(2, 2);
    A << 0.0, -1.0, 1.0, 0.0;
    const VectorXd b = Eigen::Vector2d(1.0, 2.0);
    const GmresReport report = gmres(times_vector(A), same_vector, b, 1e-12, 10);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 2);
    EXPECT_LT((report.solution - Eigen::Vector2d(2.0, -1.0)).norm(), 1e-12);
    EXPECT_TRUE(conjugate_gradient(times(A), same, b, 1e-12, 10).negative_curvature);
    // The exact inverse as preconditioner needs one; a guess of another length is none.
    const GmresReport once = gmres(times_vector(A), times_vector(A.transpose()), b, 1e-12, 10, VectorXd::Ones(3));
    EXPECT_TRUE(once.converged);
    EXPECT_EQ(once.iterations, 1);
    const GmresReport zero = gmres(times_vector(A), same_vector, VectorXd::Zero(2), 1e-12, 10);
    EXPECT_TRUE(zero.converged);
    EXPECT_EQ(zero.iterations, 0);
    EXPECT_TRUE(zero.solution.isZero(0.0));
    EXPECT_FALSE(gmres(times_vector(A), same_vector, b, 1e-12, 0).converged) << "no step is allowed";
}

/// Empty columns, a missing diagonal, no columns at all; and the product is linear and symmetric.
TEST(Iterations, ProductsWithTriangleOfAnyPattern) {
    SymmetricSparse lower(6, 6);
    lower.insert(3, 0) = 2.0;  // a column without its diagonal
    lower.insert(1, 1) = -1.0;
    lower.insert(5, 1) = 4.0;
    lower.insert(5, 5) = 0.5;  // columns 2 to 4 are empty
    lower.makeCompressed();
    const MatrixXd full = MatrixXd(lower).selfadjointView<Eigen::Lower>();
    EXPECT_EQ(symmetric_product(lower, MatrixXd::Identity(6, 6)), full);
    EXPECT_EQ(symmetric_product(lower, MatrixXd(6, 0)).cols(), 0);
    const SymmetricSparse grid = test::laplacian(4, 3, 2, 0.3);
    const MatrixXd of_grid = symmetric_product(grid, MatrixXd::Identity(24, 24));  // 16 columns and 8 more
    EXPECT_EQ(of_grid, MatrixXd(of_grid.transpose()));
    EXPECT_EQ(of_grid, MatrixXd(MatrixXd(grid).selfadjointView<Eigen::Lower>()));
}

}  // namespace
}  // namespace myo::solver::iterations_test
