#include "prediction/vibration_in_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "dynamics/material_damping.hpp"
#include "dynamics/natural_modes.hpp"
#include "support/beam.hpp"

namespace myo::prediction::vibration_in_motion_test {
namespace {

using Eigen::Matrix3Xd;

/// A beam wider than high, so that its two first modes are apart, with a marker at a corner of its end.
struct Vibrating {
    model::Model model;
    measurement::MarkerSet markers;
    std::vector<dynamics::NaturalMode> modes;
    Eigen::Index corner = 0;

    Vibrating() {
        test::BeamSpec spec;
        spec.size = {0.1, 0.03, 0.02};
        spec.poissons_ratio = 0.3;
        model = test::make_beam(spec);
        const Eigen::Vector3d at(0.1, 0.03, 0.02);
        const Matrix3Xd& rest = model.body->mesh.nodes;
        (rest.colwise() - at).colwise().norm().minCoeff(&corner);
        markers = measurement::marker_set(model.body->mesh, {at});
        dynamics::StageSolver solver(model);
        modes = dynamics::natural_modes(solver, rest, 6).modes;
    }

    /// Motion in the first two modes with these amplitudes of the modal coordinates, with 100 steps in a period of the
    /// second one, for whole periods of both up to rounding; `drift` is an acceleration of the first.
    dynamics::Trace motion(double first, double second, double drift = 0.0, int steps = 2000) const {
        dynamics::Trace trace;
        trace.status = dynamics::RunStatus::complete;
        const Matrix3Xd& rest = model.body->mesh.nodes;
        const double h = 2.0 * std::numbers::pi / modes[1].omega_rad_s / 100.0;
        for (int k = 0; k <= steps; ++k) {
            const double t = h * k, a = modes[0].omega_rad_s, b = modes[1].omega_rad_s;
            trace.times_s.push_back(t);
            trace.positions.push_back(rest);
            trace.velocities.emplace_back((first * a * std::cos(a * t) + drift * t) * modes[0].shape +
                                          second * b * std::cos(b * t) * modes[1].shape);
        }
        return trace;
    }
    /// Rms over coordinates and time at the marker of a motion of amplitude 1 in a mode.
    double rms(std::size_t mode) const {
        return modes[mode].shape.col(corner).norm() / std::sqrt(3.0) / std::sqrt(2.0);
    }
};

TEST(VibrationsInMotion, HaveTheirAmplitudesAtTheMarkersLargestFirst) {
    const Vibrating beam;
    ASSERT_EQ(beam.modes.size(), 6u);
    ASSERT_GT(beam.modes[1].omega_rad_s, 1.05 * beam.modes[0].omega_rad_s);
    const double first = 1e-3 / beam.rms(0), second = 2e-3 / beam.rms(1);
    const std::vector<Vibration> seen = vibrations_in(beam.model, beam.markers, beam.motion(first, second));
    ASSERT_GE(seen.size(), 2u);
    // Third derivatives by differences are too small by (omega h)^2 / 12; the first mode ends within a period.
    EXPECT_NEAR(seen[0].omega_rad_s, beam.modes[1].omega_rad_s, 1e-6 * beam.modes[1].omega_rad_s);
    EXPECT_NEAR(seen[0].amplitude_m, 2e-3, 0.01 * 2e-3);
    EXPECT_NEAR(seen[1].omega_rad_s, beam.modes[0].omega_rad_s, 1e-6 * beam.modes[0].omega_rad_s);
    EXPECT_NEAR(seen[1].amplitude_m, 1e-3, 0.05 * 1e-3);
    for (std::size_t i = 2; i < seen.size(); ++i) EXPECT_LT(seen[i].amplitude_m, 1e-6);
    EXPECT_EQ(seen[0].damping_ratio, 0.0);
}

TEST(VibrationsInMotion, AreNoneInASteadyAcceleration) {
    const Vibrating beam;
    // Ten times as far as the vibration of 1 mm, within the time of the motion.
    const dynamics::Trace swinging = beam.motion(1e-3 / beam.rms(0), 0.0);
    const double end_s = swinging.times_s.back(), drift = 20.0 * 1e-3 / beam.rms(0) / (end_s * end_s);
    const std::vector<Vibration> both = vibrations_in(beam.model, beam.markers,
                                                      beam.motion(1e-3 / beam.rms(0), 0.0, drift));
    const std::vector<Vibration> plain = vibrations_in(beam.model, beam.markers, swinging);
    ASSERT_FALSE(both.empty());
    ASSERT_FALSE(plain.empty());
    EXPECT_NEAR(both[0].amplitude_m, plain[0].amplitude_m, 1e-3 * plain[0].amplitude_m);
    for (const Vibration& vibration : vibrations_in(beam.model, beam.markers, beam.motion(0.0, 0.0, drift)))
        EXPECT_LT(vibration.amplitude_m, 1e-8);
}

TEST(VibrationsInMotion, NeedThreeStatesAndHalfOfTheCriticalDampingAtMost) {
    Vibrating beam;
    EXPECT_TRUE(vibrations_in(beam.model, beam.markers, beam.motion(1.0, 0.0, 0.0, 1)).empty());
    EXPECT_FALSE(vibrations_in(beam.model, beam.markers, beam.motion(1.0, 0.0, 0.0, 2)).empty());
    const dynamics::NaturalMode& slowest = beam.modes[0];
    const double factor = dynamics::damping_factor(beam.model, beam.model.body->mesh.nodes, slowest);
    for (const double ratio : {0.49, 0.51}) {
        beam.model.damping_s = ratio / dynamics::damping_ratio(factor, 1.0, slowest.omega_rad_s);
        const std::vector<Vibration> seen = vibrations_in(beam.model, beam.markers, beam.motion(1.0, 1.0));
        // Faster modes are damped more.
        ASSERT_EQ(seen.size(), ratio < 0.5 ? 1u : 0u) << ratio;
        if (seen.empty()) continue;
        EXPECT_NEAR(seen[0].damping_ratio, ratio, 1e-6);
        EXPECT_NEAR(seen[0].omega_rad_s, slowest.omega_rad_s, 1e-6 * slowest.omega_rad_s);
    }
}

}  // namespace
}  // namespace myo::prediction::vibration_in_motion_test
