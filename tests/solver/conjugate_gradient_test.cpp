#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "solver/conjugate_gradient.hpp"

namespace myo {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const LinearOperator nothing = [](const VectorXd& v) { return v; };

MatrixXd spd(int n) {
    std::srand(9);
    const MatrixXd A = MatrixXd::Random(n, n);
    return A * A.transpose() + MatrixXd::Identity(n, n);
}

LinearOperator product(const MatrixXd& A) {
    return [&A](const VectorXd& v) { return VectorXd(A * v); };
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
    const LinearOperator inverse = [&](const VectorXd& v) { return VectorXd(v.cwiseQuotient(d)); };
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

TEST(ConjugateGradient, ZeroRightHandSideIsDoneAtOnce) {
    const MatrixXd A = spd(4);
    const ConjugateGradientReport report = conjugate_gradient(product(A), nothing, VectorXd::Zero(4), 1e-10, 10);
    EXPECT_TRUE(report.converged);
    EXPECT_EQ(report.iterations, 0);
    EXPECT_TRUE(report.solution.isZero(0.0));
}

}  // namespace
}  // namespace myo
