#include "model/one_sided.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "base/decompositions.hpp"
#include "model/positive_part.hpp"

namespace myo::model::one_sided_tests {
namespace {

using Eigen::MatrixXd;

constexpr double onset_m = 2e-3;

TEST(OneSided, IsNothingUpToZeroAndAParabolaBeyondItsOnset) {
    for (const double t : {-1.0, -1e-300, 0.0}) {
        EXPECT_EQ(one_sided(t, onset_m).value, 0.0);
        EXPECT_EQ(one_sided(t, onset_m).slope, 0.0);
        EXPECT_EQ(one_sided(t, onset_m).second, 0.0);
    }
    for (const double t : {2e-3, 3e-3, 0.5, 1e6}) {
        EXPECT_NEAR(one_sided(t, onset_m).slope, t - 1e-3, 1e-12 * t);
        EXPECT_EQ(one_sided(t, onset_m).second, 1.0);
    }
    EXPECT_NEAR(one_sided(1e-3, onset_m).second, 0.5, 1e-15);
    EXPECT_NEAR(one_sided(1e-3, onset_m).slope, 1e-3 / 4.0, 1e-18) << "an eighth of the onset at its middle";
}

TEST(OneSided, HasTheDerivativesOfItsValueThroughout) {
    const double d = 1e-7;
    for (const double t : {1e-4, 7e-4, 1.9e-3, 2.1e-3, 5e-3}) {
        const OneSided up = one_sided(t + d, onset_m), down = one_sided(t - d, onset_m), here = one_sided(t, onset_m);
        EXPECT_NEAR((up.value - down.value) / (2.0 * d), here.slope, 1e-9 * onset_m);
        EXPECT_NEAR((up.slope - down.slope) / (2.0 * d), here.second, 1e-7);
    }
}

TEST(OneSided, IsTwiceContinuouslyDifferentiableWhereItsPiecesMeet) {
    for (const double t : {0.0, onset_m}) {
        const double close = 1e-12;
        const OneSided below = one_sided(t - close, onset_m), above = one_sided(t + close, onset_m);
        EXPECT_NEAR(below.value, above.value, 1e-14);
        EXPECT_NEAR(below.slope, above.slope, 3.0 * close);
        EXPECT_NEAR(below.second, above.second, 3.0 * close / onset_m);
    }
}

TEST(OneSided, ScalesWithItsLengths) {
    for (const double t : {-0.5, 0.3, 0.9, 1.7}) {
        const OneSided unit = one_sided(t, 1.0), scaled = one_sided(1e-4 * t, 1e-4);
        EXPECT_NEAR(scaled.value, 1e-8 * unit.value, 1e-21);
        EXPECT_NEAR(scaled.slope, 1e-4 * unit.slope, 1e-18);
        EXPECT_NEAR(scaled.second, unit.second, 1e-14);
    }
}

/// A matrix with these eigenvalues about oblique axes.
MatrixXd with_eigenvalues(const Eigen::Vector3d& values) {
    const Eigen::Matrix3d Q = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1.0, -2.0, 0.4).normalized()).toRotationMatrix();
    return Q * values.asDiagonal() * Q.transpose();
}

TEST(PositivePart, ReplacesNegativeEigenvaluesByZeroAndKeepsTheAxes) {
    for (const Eigen::Vector3d& values :
         {Eigen::Vector3d(-3.0, 1.0, 4.0), Eigen::Vector3d(-3.0, -1.0, 4.0), Eigen::Vector3d(-5.0, -2.0, -1.0),
          Eigen::Vector3d(-1e-9, 2.0, 2.0), Eigen::Vector3d(-1e8, 1.0, 1e8)}) {
        MatrixXd K = with_eigenvalues(values);
        project_positive(K);
        const Eigen::Vector3d positive = values.cwiseMax(0.0);
        EXPECT_LT((K - with_eigenvalues(positive)).norm(), 1e-13 * values.norm()) << values.transpose();
        EXPECT_LT((K - K.transpose()).norm(), 1e-14 * values.norm());
    }
}

TEST(PositivePart, LeavesASemidefiniteMatrixAsItIs) {
    for (const Eigen::Vector3d& values : {Eigen::Vector3d(1.0, 2.0, 3.0), Eigen::Vector3d(7.0, 7.0, 7.0)}) {
        const MatrixXd before = with_eigenvalues(values);
        MatrixXd K = before;
        project_positive(K);
        EXPECT_EQ(K, before);
    }
    MatrixXd none = MatrixXd::Zero(4, 4);
    project_positive(none);
    EXPECT_EQ(none.norm(), 0.0);
    MatrixXd single = MatrixXd::Constant(1, 1, -2.0);
    project_positive(single);
    EXPECT_EQ(single(0, 0), 0.0);
}

/// No semidefinite matrix lies nearer than what the projection takes off.
TEST(PositivePart, IsTheNearestSemidefiniteMatrix) {
    const MatrixXd before = with_eigenvalues({-2.0, 0.5, 3.0});
    MatrixXd K = before;
    project_positive(K);
    EXPECT_NEAR((K - before).norm(), 2.0, 1e-13);
    EXPECT_GT(symmetric_eigenvalues(K)(0), -1e-13);
    // The part taken off is negative and stands on what is kept.
    EXPECT_NEAR((K - before).cwiseProduct(K).sum(), 0.0, 1e-13);
}

}  // namespace
}  // namespace myo::model::one_sided_tests
