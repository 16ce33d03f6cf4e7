#include <gtest/gtest.h>

#include "dynamics/extrapolation.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Two nodes on parabolas.
Matrix3Xd at(double t) {
    Matrix3Xd x(3, 2);
    x.col(0) = Vector3d(1.0 + 2.0 * t - 0.5 * t * t, -t, 0.3 * t * t);
    x.col(1) = Vector3d(0.0, 4.0 + t, 0.1 * t);
    return x;
}

TEST(Extrapolation, ContinuesAParabolaOverUnequalSteps) {
    Extrapolation past;
    past.restart(0.0, at(0.0));
    past.add(0.2, at(0.2));
    EXPECT_FALSE(past.at(0.5));
    past.add(0.5, at(0.5));
    ASSERT_TRUE(past.at(0.9));
    EXPECT_LT((*past.at(0.9) - at(0.9)).norm(), 1e-13);
    past.add(0.9, at(0.9));  // the oldest goes
    EXPECT_LT((*past.at(1.0) - at(1.0)).norm(), 1e-13);
}

TEST(Extrapolation, StartsAnewAfterAJumpAndIsSilentWhereStepsAreTooLong) {
    Extrapolation past;
    for (const double t : {0.0, 0.2, 0.4}) past.add(t, at(t));
    past.restart(0.4, at(0.4));
    EXPECT_FALSE(past.at(0.6));
    past.add(0.6, at(0.6));
    past.add(0.8, at(0.4));  // turns back: the velocity changes its sign
    EXPECT_FALSE(past.at(1.0));
}

}  // namespace
}  // namespace myo::dynamics
