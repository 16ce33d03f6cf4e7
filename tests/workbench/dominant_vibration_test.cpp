#include "backend/dominant_vibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace myo {
namespace {

/// A release at 3 Hz with offset, decaying with this damping ratio, at 100 Hz.
Eigen::VectorXd release(const Eigen::VectorXd& t, double ratio) {
    const double omega = 2.0 * std::numbers::pi * 3.0, rate = ratio * omega / std::sqrt(1.0 - ratio * ratio);
    return 0.02 - 0.01 * (-rate * t.array()).exp() * (omega * t.array()).cos();
}

TEST(DominantVibration, FindsFrequencyAndDampingOfADecayingSine) {
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(301, 0.0, 3.0);
    for (const double ratio : {0.02, 0.06, 0.12}) {
        const backend::MeasuredVibration found = backend::vibration_of(t, release(t, ratio));
        EXPECT_NEAR(found.frequency_Hz, 3.0, 0.05) << ratio;
        EXPECT_NEAR(found.damping_ratio, ratio, 1e-3) << ratio;
    }
}

TEST(DominantVibration, IsNotMisledByARecordThatEndsBeforeTheRest) {
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(91, 0.0, 0.9);
    const backend::MeasuredVibration found = backend::vibration_of(t, release(t, 0.02));
    EXPECT_NEAR(found.frequency_Hz, 3.0, 0.01);
    EXPECT_NEAR(found.damping_ratio, 0.02, 1e-3);
}

TEST(DominantVibration, LooksBetweenGaps) {
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(301, 0.0, 3.0);
    Eigen::VectorXd y = release(t, 0.06);
    y.segment(20, 10).setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_NEAR(backend::vibration_of(t, y).damping_ratio, 0.06, 1e-3);
}

TEST(DominantVibration, FindsItsRestBesideAnOccludedSample) {
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(301, 0.0, 3.0);
    Eigen::VectorXd y = release(t, 0.06);
    y(290) = std::numeric_limits<double>::quiet_NaN();
    const backend::MeasuredVibration found = backend::vibration_of(t, y);
    EXPECT_NEAR(found.frequency_Hz, 3.0, 0.05);
    EXPECT_NEAR(found.damping_ratio, 0.06, 1e-3);
    y.tail(70).setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(backend::vibration_of(t, y).frequency_Hz, 0.0);
}

TEST(DominantVibration, HasNoDampingWhereNothingDecays) {
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(301, 0.0, 3.0);
    // Driven: the swing grows.
    EXPECT_TRUE(std::isnan(
        backend::vibration_of(t, (0.01 * (0.3 * t.array()).exp() * (19.0 * t.array()).sin()).matrix()).damping_ratio));
    EXPECT_EQ(backend::vibration_of(t, (-2.0 * t.array()).exp().matrix()).frequency_Hz, 0.0);
    EXPECT_TRUE(std::isnan(backend::vibration_of(t, (-2.0 * t.array()).exp().matrix()).damping_ratio));
}

}  // namespace
}  // namespace myo
