#include "effect/direction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace myo::effect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(Direction, AnglesAndDirectionsAreTheSameThing) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < 100; ++i) {
        const Vector3d base = Vector3d(number(random), number(random), number(random)).normalized();
        const Vector2d angles = 2.0 * Vector2d(number(random), number(random));  // below half a turn
        const Vector3d direction = direction_at(base, angles);
        EXPECT_NEAR(direction.norm(), 1.0, 1e-14);
        EXPECT_NEAR(std::acos(direction.dot(base)), angles.norm(), 1e-7);
        EXPECT_LT((direction_angles(base, 3.0 * direction) - angles).norm(), 1e-9);
    }
}

TEST(Direction, TheBaseHasNoAnglesAndItsOppositeHalfATurn) {
    const Vector3d base = Vector3d(1.0, 2.0, -2.0) / 3.0;
    EXPECT_EQ(direction_at(base, Vector2d::Zero()), base);
    EXPECT_LT(direction_angles(base, base).norm(), 1e-15);
    EXPECT_NEAR(direction_angles(base, -base).norm(), std::acos(-1.0), 1e-15);
}

/// Small angles move it as far, across itself and in two directions at right angles.
TEST(Direction, AnglesAreArcsAcrossTheBase) {
    const Vector3d base = Vector3d(0.6, 0.0, 0.8);
    const double angle = 1e-6;
    const Vector3d first = (direction_at(base, {angle, 0.0}) - direction_at(base, {-angle, 0.0})) / (2.0 * angle);
    const Vector3d second = (direction_at(base, {0.0, angle}) - direction_at(base, {0.0, -angle})) / (2.0 * angle);
    EXPECT_NEAR(first.norm(), 1.0, 1e-9);
    EXPECT_NEAR(second.norm(), 1.0, 1e-9);
    EXPECT_NEAR(first.dot(second), 0.0, 1e-9);
    EXPECT_NEAR(first.dot(base), 0.0, 1e-9);
    EXPECT_NEAR(second.dot(base), 0.0, 1e-9);
}

}  // namespace
}  // namespace myo::effect
