#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <random>

#include "measurement/marker_match.hpp"

namespace myo::measurement {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Places of a body 100 mm long without symmetry.
Matrix3Xd scattered(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(0.0, 0.1), y(0.0, 0.03);
    Matrix3Xd places(3, count);
    for (int i = 0; i < count; ++i) places.col(i) = Vector3d(x(random), y(random), y(random));
    return places;
}

const RigidMotion camera{Eigen::AngleAxisd(2.1, Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix(),
                         {0.4, -0.7, 1.2}};

/// What cameras see: the places in another order, with noise, moved.
Matrix3Xd seen_from(const Matrix3Xd& rest_m, const std::vector<int>& order, double noise_m) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, noise_m);
    Matrix3Xd seen(3, static_cast<Eigen::Index>(order.size()));
    for (std::size_t i = 0; i < order.size(); ++i)
        seen.col(static_cast<Eigen::Index>(i)) = camera.inverse().apply(
            rest_m.col(order[i]) + Vector3d(noise(random), noise(random), noise(random)));
    return seen;
}

TEST(MarkerMatch, FindsOrderAndMotion) {
    const Matrix3Xd rest = scattered(8, 1);
    const std::vector<int> order{3, 7, 0, 5, 1, 6, 2, 4};
    const Result<MarkerMatch> match = match_markers(rest, seen_from(rest, order, 2e-4), 2e-3);
    ASSERT_TRUE(match) << match.error().text();
    EXPECT_EQ(match->count(), 8);
    EXPECT_TRUE(match->unique);
    for (int i = 0; i < 8; ++i) EXPECT_EQ(match->seen[order[static_cast<std::size_t>(i)]], i);
    EXPECT_LT(match->rms_m, 4e-4);
    EXPECT_LT(rotation_angle(match->motion.rotation * camera.rotation.transpose()), 0.02);
}

TEST(MarkerMatch, LeavesOutWhatIsHiddenAndWhatIsForeign) {
    const Matrix3Xd rest = scattered(7, 2);
    // Markers 2 and 6 are hidden; two things lie about, and one track is empty.
    Matrix3Xd seen(3, 8);
    seen.leftCols<5>() = seen_from(rest, {5, 1, 4, 0, 3}, 1e-4);
    seen.col(5) = Vector3d(0.1, 0.2, 0.3);
    seen.col(6).setConstant(std::numeric_limits<double>::quiet_NaN());
    seen.col(7) = Vector3d(-0.3, 0.0, 0.9);
    const Result<MarkerMatch> match = match_markers(rest, seen, 2e-3);
    ASSERT_TRUE(match);
    EXPECT_EQ(match->seen, (Eigen::VectorXi(7) << 3, 1, -1, 4, 2, 0, -1).finished());
}

TEST(MarkerMatch, TellsASymmetricArrangementByTheExpectedRotation) {
    Matrix3Xd rest(3, 4);  // a rectangle, which half a turn brings onto itself
    rest << 0.0, 0.1, 0.1, 0.0, 0.0, 0.0, 0.04, 0.04, 0.0, 0.0, 0.0, 0.0;
    const Matrix3Xd seen = seen_from(rest, {0, 1, 2, 3}, 0.0);
    const Result<MarkerMatch> match = match_markers(rest, seen, 1e-3, camera.rotation);
    ASSERT_TRUE(match);
    EXPECT_FALSE(match->unique);
    EXPECT_EQ(match->seen, Eigen::Vector4i(0, 1, 2, 3));
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(M_PI, Vector3d::UnitZ()).toRotationMatrix() * camera.rotation;
    EXPECT_EQ(match_markers(rest, seen, 1e-3, turned)->seen, Eigen::Vector4i(2, 3, 0, 1));
}

TEST(MarkerMatch, OnOneLineKeepsTheExpectedRotation) {
    Matrix3Xd rest(3, 3);
    rest << 0.0, 0.03, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0;
    const Matrix3Xd seen = seen_from(rest, {2, 0, 1}, 0.0);
    const Result<MarkerMatch> match = match_markers(rest, seen, 1e-3, camera.rotation);
    ASSERT_TRUE(match);
    EXPECT_EQ(match->seen, Eigen::Vector3i(1, 2, 0));
    EXPECT_LT(rotation_angle(match->motion.rotation * camera.rotation.transpose()), 1e-9);
}

TEST(MarkerMatch, NeedsSomethingOnBothSides) {
    EXPECT_FALSE(match_markers(Matrix3Xd(3, 0), scattered(3, 1), 1e-3));
    EXPECT_FALSE(
        match_markers(scattered(3, 1), Matrix3Xd::Constant(3, 2, std::numeric_limits<double>::quiet_NaN()), 1e-3));
}

}  // namespace
}  // namespace myo::measurement
