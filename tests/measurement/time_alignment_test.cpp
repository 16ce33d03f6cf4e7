#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "measurement/time_alignment.hpp"

namespace myo::measurement {
namespace {

using Eigen::Matrix3Xd;

/// A body that is let go at t = 0 and rings down.
Matrix3Xd swing(const Eigen::VectorXd& time_s, double amplitude_m, double phase_s = 0.0) {
    Matrix3Xd track = Matrix3Xd::Zero(3, time_s.size());
    for (Eigen::Index i = 0; i < time_s.size(); ++i) {
        const double t = std::max(0.0, time_s[i] - phase_s);
        track(2, i) = amplitude_m * (std::exp(-2.0 * t) * std::cos(19.0 * t) - 1.0);
        track(0, i) = 0.1 + 0.2 * track(2, i);
    }
    return track;
}

TEST(TimeAlignment, FindsTheReleaseToATenthOfASample) {
    const Eigen::VectorXd simulated = Eigen::VectorXd::LinSpaced(151, 0.0, 1.5),
                          recorded = Eigen::VectorXd::LinSpaced(301, 0.0, 3.0);
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0.0, 3e-4);
    Matrix3Xd seen = swing(recorded, 0.02, 1.2345);
    for (double& value : seen.reshaped()) value += noise(random);
    seen.middleCols(140, 6).setConstant(
        std::numeric_limits<double>::quiet_NaN());  // hidden in the middle of the motion
    const auto found = align_in_time(simulated, {swing(simulated, 0.017)}, recorded,
                                     {seen});  // the model is 15 % too stiff
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_NEAR(found->delay_s, 1.2345, 1.5e-3);
    EXPECT_GT(found->correlation, 0.98);
}

TEST(TimeAlignment, RefusesWhatDoesNotMove) {
    const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(50, 0.0, 1.0);
    EXPECT_FALSE(align_in_time(time, {Matrix3Xd::Zero(3, 50)}, time, {swing(time, 0.01)}));
    EXPECT_FALSE(align_in_time(time, {}, time, {}));
    EXPECT_FALSE(align_in_time(time.head(4), {Matrix3Xd::Zero(3, 4)}, time, {swing(time, 0.01)}));
}

}  // namespace
}  // namespace myo::measurement
