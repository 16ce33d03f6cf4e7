#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "diagnosis/fit/repeatability.hpp"

// Repeated trials of hand-made motions, whose differences have closed forms.

namespace myo::diagnosis::repeat_limits_test {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double below = 0.999, above = 1.001, interval_s = 0.01;

/// Three markers on a right angle of 0.1 m, recorded twice in 12 samples; predicted and measured alike.
struct Repeated {
    setup::Setup setup;
    std::vector<prediction::TrialPrediction> runs = std::vector<prediction::TrialPrediction>(2);

    explicit Repeated(const Vector3d& velocity_m_s = Vector3d::Zero()) {
        setup.marker_names = {"a", "b", "c"};
        setup.noise_m = Vector3d(1e-4, 5e-4, 7e-4);  // rms 5e-4
        setup.trials.resize(2);
        for (std::size_t t = 0; t < 2; ++t) {
            setup.trials[t].measured.time_s = interval_s * Eigen::VectorXd::LinSpaced(12, 0.0, 11.0);
            runs[t].status = dynamics::RunStatus::complete;
            for (const Vector3d& rest : {Vector3d(0.0, 0.0, 0.0), Vector3d(0.1, 0.0, 0.0), Vector3d(0.0, 0.1, 0.0)}) {
                const Matrix3Xd motion = velocity_m_s * setup.trials[t].measured.time_s.transpose();
                runs[t].positions_m.emplace_back(motion.colwise() + rest);
                runs[t].residual_m.emplace_back(Matrix3Xd::Zero(3, 12));
            }
        }
    }
    /// Adds to every residual of the second trial what `change` gives for its marker.
    template <class Change>
    void displace(const Change& change) {
        for (std::size_t m = 0; m < 3; ++m) runs[1].residual_m[m].colwise() += Vector3d(change(m));
    }
    Vector3d arm(std::size_t m) const {  // from the mean of the markers
        const std::vector<Matrix3Xd>& p = runs[0].positions_m;
        return p[m].col(0) - (p[0].col(0) + p[1].col(0) + p[2].col(0)) / 3.0;
    }
    Repeatability found(const RepeatPolicy& policy = {}) const { return repeatability(setup, runs, policy); }
};

/// A trial is half of the difference off the mean of both: in three coordinates |d|^2 / 2 / 3.
TEST(RepeatLimits, AreHalfTheSquaredDifferencePerMarker) {
    Repeated of;
    of.displace([](std::size_t m) { return Vector3d(0.0, m == 1 ? 6e-4 : 0.0, m == 0 ? 3e-4 : 0.0); });
    of.runs[0].residual_m[2].setConstant(std::numeric_limits<double>::quiet_NaN());
    const Repeatability found = of.found();
    ASSERT_TRUE(found.known());
    EXPECT_NEAR(found.marker_rms_m(0), 3e-4 / std::sqrt(6.0), 1e-15);
    EXPECT_NEAR(found.marker_rms_m(1), 6e-4 / std::sqrt(6.0), 1e-15);
    EXPECT_TRUE(std::isnan(found.marker_rms_m(2))) << "never seen";
    EXPECT_NEAR(found.rms_m, std::sqrt((9.0 + 36.0) / 2.0 / 6.0) * 1e-4, 1e-15);
}

/// A shift in time moves the markers along their velocity, and nothing across it.
TEST(RepeatLimits, TakeOutAShiftInTimeAlone) {
    const Vector3d velocity_m_s(0.3, 0.0, 0.4);
    Repeated of(velocity_m_s);
    of.displace([&](std::size_t) { return Vector3d(0.002 * velocity_m_s); });
    ASSERT_TRUE(of.found().known());
    EXPECT_LT(of.found().rms_m, 1e-12);
    of.displace([](std::size_t) { return Vector3d(0.0, 2e-4, 0.0); });
    EXPECT_NEAR(of.found().rms_m, 2e-4 / std::sqrt(6.0), 1e-12);
}

/// A rotation is an error of the registration, unless that is known; a stretch is orthogonal to all rigid motions.
TEST(RepeatLimits, TakeOutARotationButNoStretch) {
    Repeated turned, stretched;
    turned.displace([&](std::size_t m) { return Vector3d(0.0, 0.0, 0.01).cross(turned.arm(m)); });
    stretched.displace([&](std::size_t m) { return Vector3d(0.01 * stretched.arm(m)); });
    // Squares of the arms: 2, 5 and 5 ninths of that of the side; 9 coordinates.
    const double rms_m = 0.01 * 0.1 * std::sqrt(12.0 / 9.0 / 2.0 / 9.0);
    EXPECT_NEAR(turned.found().rms_m, rms_m, 1e-12);
    EXPECT_NEAR(stretched.found().rms_m, rms_m, 1e-12);
    for (Repeated* of : {&turned, &stretched}) of->setup.experiment.registration.known = false;
    EXPECT_LT(turned.found().rms_m, 1e-12);
    EXPECT_NEAR(stretched.found().rms_m, rms_m, 1e-12);
}

/// Samples of the second trial lie three tenths of an interval later. Residuals linear in time are interpolated without
/// an error; the first sample has nothing before it.
TEST(RepeatLimits, InterpolateBetweenTheSamples) {
    Repeated of;
    of.setup.trials[1].measured.time_s.array() += 0.3 * interval_s;
    for (std::size_t t = 0; t < 2; ++t)
        for (Matrix3Xd& residual : of.runs[t].residual_m)
            residual = Vector3d(0.1, -0.2, 0.3) * of.setup.trials[t].measured.time_s.transpose();
    RepeatPolicy policy;
    policy.min_samples = 33;
    ASSERT_TRUE(of.found(policy).known()) << "three markers in eleven samples";
    EXPECT_LT(of.found(policy).rms_m, 1e-15);
    policy.min_samples = 34;
    EXPECT_FALSE(of.found(policy).known());
}

TEST(RepeatLimits, NeedMotionsThatAgreeFarBelowTheNoise) {
    for (const double share : {below, above}) {
        Repeated of;
        of.runs[1].positions_m[1](2, 5) += share * RepeatPolicy{}.same_motion * 5e-4;
        EXPECT_EQ(of.found().known(), share < 1.0);
    }
    Repeated held, failed;
    held.setup.trials[1].hold = true;
    EXPECT_FALSE(held.found().known()) << "a pose and a motion";
    failed.runs[0].status = dynamics::RunStatus::failed;
    EXPECT_FALSE(failed.found().known());
    EXPECT_EQ(failed.found().marker_rms_m.size(), 3);
}

}  // namespace
}  // namespace myo::diagnosis::repeat_limits_test
