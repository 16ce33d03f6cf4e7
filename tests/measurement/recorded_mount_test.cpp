#include "measurement/recorded_mount.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

#include "base/cross_matrix.hpp"
#include "measurement/smoothing_spline.hpp"
#include "support/figures.hpp"
#include "support/turning_mount.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

/// Places of four markers on a mount.
Matrix3Xd on_mount() {
    Matrix3Xd rest(3, 4);
    rest << -0.06, 0.05, 0.0, -0.02, 0.0, 0.02, 0.07, -0.05, -0.02, 0.0, 0.01, 0.05;
    return rest;
}

/// Markers of a moving mount with white noise.
Recording seen(const model::MountMotion& motion, const Matrix3Xd& rest, double rate_Hz, int samples, double noise_m,
               double first_s = 0.0) {
    Recording recording;
    recording.rate_Hz = rate_Hz;
    recording.time_s = VectorXd::LinSpaced(samples, first_s, first_s + (samples - 1) / rate_Hz);
    recording.tracks.assign(static_cast<std::size_t>(rest.cols()), Matrix3Xd(3, samples));
    std::mt19937_64 random(3);
    std::normal_distribution<double> noise(0.0, 1.0);
    for (Index t = 0; t < samples; ++t) {
        const Matrix3Xd places = motion.at(recording.time_s(t)).in_laboratory(rest);
        for (Index m = 0; m < rest.cols(); ++m)
            for (int axis = 0; axis < 3; ++axis)
                recording.tracks[static_cast<std::size_t>(m)](axis, t) = places(axis, m) + noise_m * noise(random);
    }
    return recording;
}

/// Without noise the spline is the signal, with it the error falls far below the noise, and nothing is delayed.
TEST(SmoothingSpline, KeepsTheSignalWithoutDelay) {
    const double frames_Hz = 100.0, f = 3.0, amplitude = 0.01;
    const int samples = 400;
    const VectorXd times = VectorXd::LinSpaced(samples, 0.0, (samples - 1) / frames_Hz);
    for (const double noise_m : {0.0, 1e-4, 1e-3}) {
        std::mt19937_64 random(7);
        std::normal_distribution<double> noise(0.0, 1.0);
        MatrixXd y(1, samples);
        for (int t = 0; t < samples; ++t)
            y(0, t) = amplitude * std::sin(2.0 * pi * f * times(t)) + noise_m * noise(random);
        const QuinticSpline spline = smoothing_spline(times, y, noise_m * noise_m);
        // Away from the ends, over ten periods.
        double squares = 0.0, of_acceleration = 0.0, in_phase = 0.0, across = 0.0, count = 0.0;
        for (int k = 0; k < 1000; ++k) {
            const double t = 0.3 + 10.0 / f * k / 1000.0;
            const double s = std::sin(2.0 * pi * f * t), c = std::cos(2.0 * pi * f * t), x = spline.at(t)(0);
            squares += std::pow(x - amplitude * s, 2);
            of_acceleration += std::pow(spline.at(t, 2)(0) + std::pow(2.0 * pi * f, 2) * amplitude * s, 2);
            in_phase += x * s;
            across += x * c;
            count += 1.0;
        }
        const double error = std::sqrt(squares / count),
                     acceleration = std::sqrt(of_acceleration / count) /
                                    (std::pow(2.0 * pi * f, 2) * amplitude / std::sqrt(2.0));
        const std::string at = std::to_string(1e3 * noise_m) + "_mm";
        test::record("error_over_noise_" + at, noise_m > 0.0 ? error / noise_m : error / amplitude);
        test::record("acceleration_" + at, acceleration);
        test::record("delay_s_" + at, -std::atan2(across, in_phase) / (2.0 * pi * f));
        EXPECT_LT(error, noise_m > 0.0 ? 0.6 * noise_m : 1e-5 * amplitude);
        EXPECT_LT(acceleration, noise_m == 0.0 ? 1e-3 : noise_m < 5e-4 ? 0.06 : 0.25);
        EXPECT_LT(std::abs(across / in_phase), noise_m == 0.0 ? 1e-6 : 0.2 * noise_m / amplitude);
    }
}

TEST(RecordedMount, IsTheMotionOfItsMarkers) {
    test::TurningMount mount;
    mount.swing_rad = 0.3;
    mount.omega_rad_s = 12.0;
    mount.drift_m_s = {0.02, 0.0, -0.01};
    mount.shake_m = {0.004, 0.0, 0.006};
    const Matrix3Xd rest = on_mount();
    Recording recording = seen(mount, rest, 120.0, 240, 1e-4);
    // A tenth of a second without two of the markers, and longer without one.
    for (Index t = 100; t < 112; ++t)
        for (const std::size_t m : {0u, 1u}) recording.tracks[m].col(t).setConstant(std::nan(""));
    for (Index t = 150; t < 200; ++t) recording.tracks[2].col(t).setConstant(std::nan(""));
    // The places are known to a millimetre.
    Matrix3Xd declared = rest;
    declared.col(2) += Vector3d(1e-3, -5e-4, 0.0);
    const Result<RecordedMount> found = recorded_mount(recording, declared, false);
    ASSERT_TRUE(found) << found.error().what;
    EXPECT_NEAR(found->noise_m, 1e-4, 1e-5);
    EXPECT_NEAR(found->gap_s, 13.0 / 120.0, 1e-6);
    EXPECT_TRUE(found->motion->turns());
    double turn = 0.0, place = 0.0, acceleration = 0.0, spin = 0.0, offset = 0.0;
    const Matrix3Xd X = Vector3d(0.03, 0.01, 0.0);
    Matrix3Xd mean = Matrix3Xd::Zero(3, 1);
    std::vector<Matrix3Xd> errors;
    for (double t = 0.1; t < 1.9; t += 0.01) {
        const model::MountPose is = found->motion->at(t), was = mount.at(t);
        errors.push_back(is.in_laboratory(X) - was.in_laboratory(X));
        mean += errors.back() / 180.0;
        turn = std::max(turn, (is.rotation - was.rotation).norm());
        spin = std::max(spin, (is.spin_rad_s - was.spin_rad_s).norm());
        const Vector3d r = X.col(0) - was.pivot_m, r_is = X.col(0) - is.pivot_m;
        const auto of = [](const model::MountPose& p, const Vector3d& arm) {
            const Eigen::Matrix3d W = cross_matrix(p.spin_rad_s);
            return Vector3d(p.acceleration_m_s2 + p.rotation * (cross_matrix(p.spin_rate_rad_s2) + W * W) * arm);
        };
        acceleration = std::max(acceleration, (of(is, r_is) - of(was, r)).norm());
    }
    for (const Matrix3Xd& error : errors) place = std::max(place, (error - mean).norm());
    offset = mean.norm();
    test::record("place_m", place);
    test::record("offset_m", offset);
    test::record("turn_rad", turn);
    test::record("spin_rad_s", spin);
    test::record("acceleration_m_s2", acceleration);
    EXPECT_LT(place, 3e-4);   // noise on an arm, and across the gap
    EXPECT_LT(offset, 5e-4);  // of the marker that sits elsewhere
    EXPECT_LT(turn, 0.02);
    EXPECT_LT(spin, 0.15);
    EXPECT_LT(acceleration, 0.4);  // of 2 m/s2
}

/// Several turns: no rotation is beyond the description.
TEST(RecordedMount, TurnsRoundAndRound) {
    test::TurningMount mount;
    mount.spin_rad_s = 9.0;
    const Result<RecordedMount> found = recorded_mount(seen(mount, on_mount(), 100.0, 300, 0.0), on_mount(), false);
    ASSERT_TRUE(found);
    for (const double t : {0.2, 1.1, 2.7}) {
        EXPECT_LT((found->motion->at(t).spin_rad_s - 9.0 * mount.axis).norm(), 1e-4);
        EXPECT_LT(found->motion->at(t).spin_rate_rad_s2.norm(), 1e-2);
        EXPECT_LT((found->motion->at(t).rotation - mount.at(t).rotation).norm(), 1e-6);
    }
}

/// Seen from another place: the motion against the rest before the start.
TEST(RecordedMount, MovesAgainstItsRestWhereTheFrameIsUnknown) {
    test::TurningMount mount;
    mount.shake_m = {0.0, 0.003, 0.0};
    mount.omega_rad_s = 15.0;
    mount.swing_rad = 0.1;
    class FromZero : public model::MountMotion {
    public:
        explicit FromZero(const test::TurningMount& motion) : motion_(motion) {}
        model::MountPose at(double t) const override {
            model::MountPose pose = motion_.at(std::max(t, 0.0));
            // A camera frame turned by half a radian.
            const Eigen::Matrix3d R = Eigen::AngleAxisd(0.5, Vector3d::UnitY()).toRotationMatrix();
            pose.rotation = R * pose.rotation;
            pose.place_m = R * pose.place_m + Vector3d(0.3, 0.2, 0.1);
            return pose;
        }
        bool turns() const override { return true; }

    private:
        const test::TurningMount& motion_;
    };
    const Recording recording = seen(FromZero(mount), on_mount(), 200.0, 400, 1e-5, -0.8);
    const Result<RecordedMount> found = recorded_mount(recording, on_mount(), true);
    ASSERT_TRUE(found);
    const Matrix3Xd X = Vector3d(0.05, 0.02, 0.01);
    for (const double t : {-0.3, 0.4, 0.9})
        EXPECT_LT((found->motion->at(t).in_laboratory(X) - mount.at(std::max(t, 0.0)).in_laboratory(X)).norm(), 5e-5)
            << t;
}

/// Noise alone turns nothing.
TEST(RecordedMount, SlidesWhereItsTurnsAreNoise) {
    test::TurningMount mount;
    mount.shake_m = {0.003, 0.0, 0.0};
    mount.omega_rad_s = 20.0;
    const auto found = [&] {
        const Result<RecordedMount> mounted = recorded_mount(seen(mount, on_mount(), 100.0, 200, 1e-4), on_mount(),
                                                             false);
        EXPECT_TRUE(mounted);
        return mounted->motion;
    };
    EXPECT_FALSE(found()->turns());
    EXPECT_EQ(found()->at(0.7).rotation, Eigen::Matrix3d::Identity());
    EXPECT_LT((found()->at(0.7).place_m - mount.at(0.7).in_laboratory(on_mount()).rowwise().mean()).norm(), 1e-4);
    mount.swing_rad = 0.02;
    EXPECT_TRUE(found()->turns());
}

TEST(RecordedMount, NeedsThreeMarkersAtOnce) {
    test::TurningMount mount;
    Recording recording = seen(mount, on_mount(), 100.0, 30, 1e-4);
    for (const std::size_t m : {0u, 3u}) recording.tracks[m].setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(recorded_mount(recording, on_mount(), false));
    // A few samples are one pose.
    const Result<RecordedMount> still = recorded_mount(seen(mount, on_mount(), 100.0, 5, 1e-5), on_mount(), false);
    ASSERT_TRUE(still);
    EXPECT_LT((still->motion->at(0.3).in_laboratory(on_mount()) - on_mount()).norm(), 1e-4);
    EXPECT_EQ(still->motion->at(0.3).spin_rad_s.norm(), 0.0);
}

}  // namespace
}  // namespace myo::measurement
