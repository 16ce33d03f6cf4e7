#include "inverse/damped_cosine.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace myo::inverse {
namespace {

using Eigen::VectorXd;

VectorXd samples(const VectorXd& t, double rate, double omega) {
    return (0.3 + (-rate * t.array()).exp() * (0.8 * (omega * t.array()).cos() - 0.6 * (omega * t.array()).sin()))
        .matrix();
}

TEST(DampedCosine, IsFoundAgainAtEveryRateAndSampling) {
    for (const double rate : {-2.0, 0.0, 2.8, 20.0})
        for (const double h : {0.0025, 0.01, 0.02}) {
            const VectorXd t = VectorXd::LinSpaced(static_cast<Eigen::Index>(1.2 / h) + 1, 0.1, 1.3);
            const DampedCosine found = fit_damped_cosine(t, samples(t, rate, 48.0));
            ASSERT_TRUE(found.ok);
            EXPECT_NEAR(found.rate_1_s, rate, 1e-6) << h;
            EXPECT_NEAR(found.omega_rad_s, 48.0, 1e-6) << h;
            EXPECT_NEAR(found.offset, 0.3, 1e-8) << h;
            EXPECT_NEAR(found.amplitude, 1.0, 1e-6) << h;
            EXPECT_NEAR(found.damping_ratio(), rate / std::hypot(rate, 48.0), 1e-7) << h;
            EXPECT_LT(found.rms, 1e-8) << h;
        }
}

TEST(DampedCosine, IsFoundInNoise) {
    const VectorXd t = VectorXd::LinSpaced(150, 0.0, 1.5);
    VectorXd y = samples(t, 2.8, 48.0);
    for (Eigen::Index k = 0; k < t.size(); ++k) y(k) += 0.01 * std::sin(12.9898 * static_cast<double>(k * k) + 78.233);
    const DampedCosine found = fit_damped_cosine(t, y);
    ASSERT_TRUE(found.ok);
    EXPECT_NEAR(found.rate_1_s, 2.8, 0.05);
    EXPECT_NEAR(found.omega_rad_s, 48.0, 0.05);
    EXPECT_NEAR(found.rms, 0.0071, 0.002);
}

TEST(DampedCosine, IsNotFoundWhereNothingSwings) {
    const VectorXd t = VectorXd::LinSpaced(100, 0.0, 1.0);
    EXPECT_FALSE(fit_damped_cosine(t, (-3.0 * t.array()).exp().matrix()).ok);
}

}  // namespace
}  // namespace myo::inverse
