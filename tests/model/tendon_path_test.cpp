#include "model/tendon_path.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/differences.hpp"

namespace myo::model::tendon_path_tests {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double right_angle = std::numbers::pi / 2.0, smooth_rad = 1e-3;

/// What a bend counts: its angle, smoothed.
double counted(double angle) { return std::hypot(angle, smooth_rad) - smooth_rad; }

/// Legs of 3, 4 and 5 m along x, y and z.
std::vector<Vector3d> stairs() { return {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {3, 4, 5}}; }

/// Oblique legs of different lengths, and motions of the guides.
std::vector<Vector3d> oblique() {
    return {{0.0, 0.0, 0.0}, {0.1, 0.02, -0.01}, {0.15, 0.08, 0.03}, {0.3, 0.1, 0.02}, {0.32, 0.1, 0.12}};
}
std::vector<Vector3d> motions(double phase) {
    std::vector<Vector3d> dp;
    for (int i = 0; i < 5; ++i)
        dp.emplace_back(std::sin(phase + 2.0 * i), std::cos(phase + 3.0 * i), std::sin(phase + 5.0 * i));
    return dp;
}

std::vector<Vector3d> shifted(const std::vector<Vector3d>& points, double step, const std::vector<Vector3d>& dp) {
    std::vector<Vector3d> result = points;
    for (std::size_t i = 0; i < points.size(); ++i) result[i] += step * dp[i];
    return result;
}

TEST(TendonPath, HasTheLengthsAndDirectionsOfItsLegs) {
    const TendonPath path = tendon_path(stairs());
    ASSERT_EQ(path.legs(), 3u);
    EXPECT_EQ(path.length, VectorXd(Vector3d(3.0, 4.0, 5.0)));
    EXPECT_EQ(path.total, 12.0);
    for (int leg = 0; leg < 3; ++leg) EXPECT_EQ(path.direction[static_cast<std::size_t>(leg)], Vector3d::Unit(leg));
    const TendonPath single = tendon_path({{1.0, 1.0, 1.0}, {1.0, 1.0, 0.5}});
    EXPECT_EQ(single.total, 0.5);
    EXPECT_EQ(single.direction.at(0), -Vector3d::UnitZ());
}

TEST(TendonPath, LengthensByMotionsAlongItsLegsAlone) {
    const TendonPath path = tendon_path(stairs());
    const Vector3d zero = Vector3d::Zero();
    EXPECT_EQ(lengthening(path, {zero, {1, 2, 3}, zero, zero}), VectorXd(Vector3d(1.0, -2.0, 0.0)));
    EXPECT_EQ(lengthening(path, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).norm(), 0.0) << "moved as a whole";
    const std::vector<Vector3d> dp = motions(0.3);
    const auto length = [&](double step) { return tendon_path(shifted(oblique(), step, dp)).length; };
    test::expect_derivative(lengthening(tendon_path(oblique()), dp), (length(1e-6) - length(-1e-6)) / 2e-6, 1e-8,
                            "lengths");
}

TEST(TendonPath, TurnsWithMotionsAcrossItsLegsOverTheirLength) {
    const TendonPath path = tendon_path(stairs());
    EXPECT_LT((turning(path, 1) - Matrix3d(Vector3d(0.25, 0.0, 0.25).asDiagonal())).norm(), 1e-16);
    EXPECT_LT((turning(path, 2) - Matrix3d(Vector3d(0.2, 0.2, 0.0).asDiagonal())).norm(), 1e-16);
    const std::vector<Vector3d> dp = motions(1.1);
    const TendonPath up = tendon_path(shifted(oblique(), 1e-6, dp)), down = tendon_path(shifted(oblique(), -1e-6, dp));
    for (std::size_t leg = 0; leg < 4; ++leg)
        test::expect_derivative(turning(tendon_path(oblique()), leg) * (dp[leg + 1] - dp[leg]),
                                (up.direction[leg] - down.direction[leg]) / 2e-6, 1e-7, "direction");
}

TEST(TendonPath, PullsItsGuidesTowardsTheirNeighbours) {
    const TendonPath path = tendon_path(stairs());
    const std::vector<Vector3d> pulls = pulls_on_guides(path, Vector3d(1.0, 2.0, 7.0));
    ASSERT_EQ(pulls.size(), 4u);
    // Derivatives of tension times length are minus the forces.
    EXPECT_EQ(pulls[0], Vector3d(-1.0, 0.0, 0.0));
    EXPECT_EQ(pulls[1], Vector3d(1.0, -2.0, 0.0));
    EXPECT_EQ(pulls[2], Vector3d(0.0, 2.0, -7.0));
    EXPECT_EQ(pulls[3], Vector3d(0.0, 0.0, 7.0));
    // A straight thread under one tension presses no guide between its ends.
    const std::vector<Vector3d> straight = pulls_on_guides(tendon_path({{0, 0, 0}, {1, 2, 2}, {3, 6, 6}}),
                                                           Eigen::Vector2d(4.0, 4.0));
    EXPECT_LT(straight[1].norm(), 1e-14);
    EXPECT_LT((straight[2] - 4.0 * Vector3d(1.0, 2.0, 2.0) / 3.0).norm(), 1e-14);
}

/// The work of the tensions along any motion of the guides is that of the legs' lengthening.
TEST(TendonPath, PullsDoTheWorkOfItsTensions) {
    const TendonPath path = tendon_path(oblique());
    const VectorXd tensions = Eigen::Vector4d(3.0, 1.0, 0.0, 5.0);
    const std::vector<Vector3d> pulls = pulls_on_guides(path, tensions), dp = motions(2.2);
    double work = 0.0;
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < pulls.size(); ++i) {
        work += pulls[i].dot(dp[i]);
        sum += pulls[i];
    }
    EXPECT_NE(work, 0.0);
    EXPECT_NEAR(work, tensions.dot(lengthening(path, dp)), 1e-13);
    EXPECT_LT(sum.norm(), 1e-14);
}

TEST(Capstan, TensionFallsByEveryBendSinceTheMotor) {
    const double f = 0.3, bend = counted(right_angle);
    const VectorXd factors = capstan_factors(tendon_path(stairs()), f);
    EXPECT_EQ(factors(0), 1.0);
    EXPECT_NEAR(factors(1), std::exp(-f * bend), 1e-12);
    EXPECT_NEAR(factors(2), std::exp(-2.0 * f * bend), 1e-12);
    // While it pays out the tension rises by as much.
    const VectorXd out = capstan_factors(tendon_path(stairs()), -f);
    EXPECT_LT((factors.cwiseProduct(out) - VectorXd::Ones(3)).norm(), 1e-14);
    EXPECT_EQ(capstan_factors(tendon_path(stairs()), 0.0), VectorXd::Ones(3));
    EXPECT_EQ(capstan_factors(tendon_path({{0, 0, 0}, {1, 0, 0}}), 5.0), VectorXd::Ones(1));
}

TEST(Capstan, CountsAnglesOfAllSizesWhateverTheLegsLength) {
    for (const double angle : {1e-6, 1e-4, 1e-3, 0.1, 1.0, 2.0, 3.0})
        for (const double length : {1e-3, 1.0, 40.0}) {
            const Vector3d turn(std::cos(angle), std::sin(angle), 0.0);
            const VectorXd factors = capstan_factors(tendon_path({{-0.7, 0.0, 0.0}, Vector3d::Zero(), length * turn}),
                                                     1.0);
            EXPECT_NEAR(-std::log(factors(1)), counted(angle), 1e-12) << angle << " " << length;
        }
    // Bends add up along a circle, less what the smoothing takes off each of them.
    std::vector<Vector3d> arc;
    for (int i = 0; i <= 21; ++i) arc.emplace_back(std::cos(0.1 * i), std::sin(0.1 * i), 0.0);
    const VectorXd factors = capstan_factors(tendon_path(arc), 0.5);
    EXPECT_NEAR(factors(20), std::exp(-0.5 * 20.0 * counted(0.1)), 1e-12);
}

/// A straight thread and one that turns back upon itself have derivatives that are numbers.
TEST(Capstan, IsFiniteForStraightAndFoldedThreads) {
    const std::vector<Vector3d> straight{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, folded{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}};
    const std::vector<Vector3d> dp{{0, 0, 0}, {0.3, 1, 2}, {0, 0, 0}};
    const TendonPath line = tendon_path(straight), fold = tendon_path(folded);
    EXPECT_EQ(capstan_factors(line, 2.0), VectorXd::Ones(2));
    EXPECT_LT(capstan_changes(line, 2.0, VectorXd::Ones(2), dp, 0.0).norm(), 1e-15) << "of second order in the bend";
    EXPECT_NEAR(capstan_factors(fold, 0.2)(1), std::exp(-0.2 * counted(std::numbers::pi)), 1e-4);
    EXPECT_TRUE(capstan_changes(fold, 0.2, capstan_factors(fold, 0.2), dp, 1.0).allFinite());
    std::vector<Vector3d> by_position(3, Vector3d::Zero());
    pull_by_capstan(fold, 0.2, capstan_factors(fold, 0.2), VectorXd::Ones(2), by_position);
    for (const Vector3d& by : by_position) EXPECT_TRUE(by.allFinite());
}

TEST(Capstan, ChangesAsItsFactorsDo) {
    const TendonPath path = tendon_path(oblique());
    for (const double f : {0.4, -0.4}) {
        const VectorXd factors = capstan_factors(path, f);
        const std::vector<Vector3d> dp = motions(0.7), still(5, Vector3d::Zero());
        const auto at = [&](double step) { return capstan_factors(tendon_path(shifted(oblique(), step, dp)), f); };
        test::expect_derivative(capstan_changes(path, f, factors, dp, 0.0), (at(1e-7) - at(-1e-7)) / 2e-7, 1e-6,
                                "positions");
        test::expect_derivative(capstan_changes(path, f, factors, still, 1.0),
                                (capstan_factors(path, f + 1e-6) - capstan_factors(path, f - 1e-6)) / 2e-6, 1e-8,
                                "coefficient");
        // Both at once are their sum.
        EXPECT_LT((capstan_changes(path, f, factors, dp, 0.7) - capstan_changes(path, f, factors, dp, 0.0) -
                   0.7 * capstan_changes(path, f, factors, still, 1.0))
                      .norm(),
                  1e-12);
    }
}

TEST(Capstan, IsTransposedByItsPull) {
    const TendonPath path = tendon_path(oblique());
    const double f = 0.4;
    const VectorXd factors = capstan_factors(path, f), by_factor = Eigen::Vector4d(0.3, -1.0, 2.0, 0.5);
    std::vector<Vector3d> by_position(5, Vector3d(1.0, 2.0, 3.0));  // what was there stays
    pull_by_capstan(path, f, factors, by_factor, by_position);
    for (const double phase : {0.0, 1.0, 2.0}) {
        const std::vector<Vector3d> dp = motions(phase);
        double pulled = 0.0;
        for (std::size_t i = 0; i < 5; ++i) pulled += (by_position[i] - Vector3d(1.0, 2.0, 3.0)).dot(dp[i]);
        const double expected = by_factor.dot(capstan_changes(path, f, factors, dp, 0.0));
        EXPECT_NE(expected, 0.0);
        EXPECT_NEAR(pulled, expected, 1e-12 * std::abs(expected) + 1e-13);
    }
}

}  // namespace
}  // namespace myo::model::tendon_path_tests
