#include "measurement/registration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/LU>

#include <random>

namespace myo::measurement {
namespace {

using testing::HasSubstr;

Eigen::Matrix3Xd random_points(int count, unsigned seed, double size = 0.1) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> place(-size, size);
    return Eigen::Matrix3Xd(3, count).unaryExpr([&](double) { return place(generator); });
}

RigidMotion random_motion(unsigned seed) {
    const Eigen::Matrix3Xd v = random_points(2, seed, 2.0);
    return {small_rotation(v.col(0)), v.col(1)};
}

TEST(RigidMotion, InverseAndCompositionAreThoseOfTheGroup) {
    const RigidMotion a = random_motion(1);
    const RigidMotion b = random_motion(2);
    const Eigen::Vector3d p(0.3, -0.2, 0.9);
    EXPECT_LT((a.inverse().apply(a.apply(p)) - p).norm(), 1e-15);
    EXPECT_LT((compose(a, b).apply(p) - a.apply(b.apply(p))).norm(), 1e-15);
}

TEST(RigidMotion, ExponentialMapIsARotationByTheLengthOfItsVector) {
    for (const double angle : {0.0, 1e-9, 1e-4, 0.09999, 0.10001, 1.0, 3.0}) {
        const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 0.5).normalized();
        const Eigen::Matrix3d R = small_rotation(angle * axis);
        EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14) << angle;
        EXPECT_NEAR(R.determinant(), 1.0, 1e-14);
        EXPECT_LT((R * axis - axis).norm(), 1e-15);
        EXPECT_NEAR(rotation_angle(R), angle, 1e-14 + 1e-9 * angle);
    }
    EXPECT_LT((small_rotation({0, 0, M_PI / 2}) * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-15);
}

TEST(RigidMotion, DerivativeEqualsCentralDifferences) {
    const Eigen::Vector3d p(0.3, -0.2, 0.9);
    for (const double angle : {0.0, 1e-6, 0.05, 0.0999, 0.1001, 0.7, 2.5}) {
        const Eigen::Vector3d omega = angle * Eigen::Vector3d(-1, 0.4, 2).normalized();
        const Eigen::Matrix3d derivative = d_rotated_d_omega(omega, p);
        Eigen::Matrix3d differences;
        const double h = 1e-5;
        for (Eigen::Index k = 0; k < 3; ++k) {
            const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(k);
            differences.col(k) = (small_rotation(omega + step) * p - small_rotation(omega - step) * p) / (2.0 * h);
        }
        EXPECT_GT(derivative.norm(), 0.1);
        EXPECT_LT((derivative - differences).norm(), 2e-10) << angle;
        EXPECT_NE(derivative, differences);
    }
}

TEST(Registration, RecoversAKnownMotionWithoutNoise) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const int count = 3 + static_cast<int>(seed % 8);
        const Eigen::Matrix3Xd from = random_points(count, seed);
        const RigidMotion truth = random_motion(seed + 1000);
        const Result<Registration> found = rigid_registration(from, truth.apply_all(from));
        ASSERT_TRUE(found) << found.error().text();
        EXPECT_LT((found->motion.rotation - truth.rotation).norm(), 1e-12);
        EXPECT_LT((found->motion.translation - truth.translation).norm(), 1e-12);
        EXPECT_LT(found->rms_m, 1e-14);
    }
}

TEST(Registration, PlanarPointsAndMirrorImagesGiveARotation) {
    Eigen::Matrix3Xd flat = random_points(6, 5);
    flat.row(2).setZero();
    const RigidMotion truth = random_motion(6);
    EXPECT_LT((rigid_registration(flat, truth.apply_all(flat))->motion.rotation - truth.rotation).norm(), 1e-12);
    const Eigen::Matrix3Xd body = random_points(6, 7);
    const Eigen::Matrix3Xd mirrored = Eigen::Vector3d(-1, 1, 1).asDiagonal() * body;
    const Result<Registration> found = rigid_registration(body, mirrored);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->motion.rotation.determinant(), 1.0, 1e-13);
    EXPECT_GT(found->rms_m, 1e-3);
}

TEST(Registration, IsTheLeastSquaresMotionAndReportsWhatIsLeft) {
    const Eigen::Matrix3Xd from = random_points(7, 8);
    const Eigen::Matrix3Xd to = random_motion(9).apply_all(from) + random_points(7, 10, 1e-3);
    Eigen::VectorXd weights(7);
    weights << 1, 2, 0.5, 0, 1, 3, 1;
    const auto sum_of_squares = [&](const RigidMotion& motion) {
        return (motion.apply_all(from) - to).colwise().squaredNorm().transpose().dot(weights) / weights.sum();
    };
    const Result<Registration> found = rigid_registration(from, to, weights);
    ASSERT_TRUE(found);
    const double best = sum_of_squares(found->motion);
    EXPECT_NEAR(found->rms_m, std::sqrt(best), 1e-12);
    EXPECT_LT((found->residual_m - (found->motion.apply_all(from) - to)).norm(), 1e-14);
    EXPECT_NEAR(found->distance_m(3), found->residual_m.col(3).norm(), 1e-16);  // weight 0 has a residual as well
    for (unsigned seed = 1; seed < 50; ++seed) {
        const Eigen::Matrix3Xd v = random_points(2, seed, 1e-3);
        EXPECT_GE(sum_of_squares(compose({small_rotation(v.col(0)), v.col(1)}, found->motion)), best);
    }
}

TEST(Registration, RefusesWhatDoesNotDetermineAMotion) {
    const Eigen::Matrix3Xd two = random_points(2, 1);
    EXPECT_THAT(rigid_registration(two, two).error().text(), HasSubstr("at least 3 points, got 2"));
    const Eigen::Vector3d direction(1, 2, -1);
    Eigen::Matrix3Xd line(3, 5);
    for (Eigen::Index k = 0; k < 5; ++k)
        line.col(k) = Eigen::Vector3d(0.4, 0.1, 7.0) + 0.1 * static_cast<double>(k * k) * direction;
    EXPECT_THAT(rigid_registration(line, line).error().text(), HasSubstr("one line"));
    EXPECT_THAT(rigid_registration(random_points(5, 2), line).error().text(), HasSubstr("one line"));
    const Eigen::Matrix3Xd same = Eigen::Matrix3Xd::Ones(3, 4);
    EXPECT_FALSE(rigid_registration(same, same));
    Eigen::Matrix3Xd hidden = random_points(5, 3);
    hidden(1, 2) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(rigid_registration(hidden, hidden).error().text(), HasSubstr("finite"));
    EXPECT_FALSE(rigid_registration(random_points(4, 3), random_points(4, 3), Eigen::Vector4d(1, 1, 0, 0)));
}

}  // namespace
}  // namespace myo::measurement
