#include <gtest/gtest.h>

#include <numbers>

#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"

namespace myo {
namespace {

using Eigen::VectorXd;

constexpr double pi = std::numbers::pi;

/// The soft beam, bent sideways by a hundredth of its length until t = 0, without gravity.
test::BeamSpec soft(const char* element) {
    test::BeamSpec spec;
    spec.kind = test::element(element);
    // What tet10 resists at its points besides distortion is not damped: 15, 2.2, 1.2 % less damping with 1, 2, 3 layers.
    spec.cells = spec.kind == ElementKind::tet10 ? Eigen::Vector3i(10, 3, 3) : Eigen::Vector3i(4, 1, 1);
    spec.size = {0.1, 0.036, 0.03};
    return spec;
}

Model held(const test::BeamSpec& spec) {
    Model model = test::make_beam(spec);
    test::push_tip(model, spec, {0.0, 0.0, -0.03 * spec.youngs_modulus_Pa * test::second_moment(spec) / (spec.size(0) * spec.size(0))});
    model.forces.back().until_s = 0.0;
    return model;
}

/// Kelvin-Voigt: damping ratio damping_s * omega / 2 of small vibrations. The rest of the ratio 2 (1 + nu) / 3 = 0.9993 is
/// volumetric and not damped.
TEST(MaterialDamping, SmallVibrationsHaveTheStatedDampingRatio) {
    for (const char* element : {"hex8", "tet10"})
        for (const double damping : {0.001, 0.004}) {
            test::BeamSpec spec = soft(element);
            spec.damping_s = damping;
            const Model model = held(spec);
            const test::Mode mode = test::first_mode(model);
            const double h = 2.0 * pi / mode.omega / 60.0;
            const VectorXd q = test::ring(model, mode, Integrator::tr_bdf2, h, 60);
            ASSERT_GT(q.size(), 0);
            const double error = test::fit_oscillation(q, h).damping_ratio / (0.5 * damping * mode.omega) - 1.0;
            test::record(std::string(element) + "_error_at_ms_" + std::to_string(static_cast<int>(1e3 * damping)), error);
            EXPECT_LT(std::abs(error), 0.02) << element << " " << damping;
        }
}

/// zeta(h) = delta / sqrt(4 pi^2 + delta^2), delta = pi ln(1 + w^2 h^2) / angle(1 + i w h).
TEST(NumericalDamping, ImplicitEulerFollowsThePapersFormula) {
    const test::BeamSpec spec = soft("hex8");
    const Model model = held(spec);
    const test::Mode mode = test::first_mode(model);
    for (const double wh : {0.1, 0.25, 0.5}) {
        const double h = wh / mode.omega;
        const VectorXd q = test::ring(model, mode, Integrator::implicit_euler, h, static_cast<int>(8.0 / wh));
        ASSERT_GT(q.size(), 0);
        const double delta = pi * std::log(1.0 + wh * wh) / std::atan(wh);
        const double exact = delta / std::sqrt(4.0 * pi * pi + delta * delta);
        const double error = test::fit_oscillation(q, h).damping_ratio / exact - 1.0;
        test::record("error_at_wh_" + std::to_string(static_cast<int>(100 * wh)), error);
        EXPECT_LT(std::abs(error), 0.02) << wh;
    }
}

/// The default scheme has no visible damping of its own; what it has follows from its stability function.
TEST(NumericalDamping, TrBdf2IsNearlyFreeOfIt) {
    const test::BeamSpec spec = soft("hex8");
    const Model model = held(spec);
    const test::Mode mode = test::first_mode(model);
    const double wh = 0.46, h = wh / mode.omega, gamma = 2.0 - std::sqrt(2.0);
    const std::complex<double> g(0.0, 0.5 * gamma * wh);
    const double c1 = 1.0 / (gamma * (2.0 - gamma)), c0 = (1.0 - gamma) * (1.0 - gamma) * c1;
    const std::complex<double> R = (c1 * (1.0 + g) / (1.0 - g) - c0) / (1.0 - g);   // trapezoid to gamma h, then BDF2
    const std::complex<double> s = std::log(R) / h;
    const VectorXd q = test::ring(model, mode, Integrator::tr_bdf2, h, 60);
    ASSERT_GT(q.size(), 0);
    const test::Oscillation motion = test::fit_oscillation(q, h);
    test::record("damping_ratio_at_wh_046", motion.damping_ratio);
    test::record("frequency_error_at_wh_046", motion.omega_damped / mode.omega - 1.0);
    EXPECT_NEAR(motion.damping_ratio / (-s.real() / std::abs(s)), 1.0, 0.02);
    EXPECT_NEAR(motion.omega_damped / s.imag(), 1.0, 1e-4);
    EXPECT_LT(motion.damping_ratio, 1e-3);
    // Error constant (3 gamma^2 - 4 gamma + 2) / (12 (2 - gamma)) = 0.0404 of the scheme, times (w h)^2.
    EXPECT_NEAR(motion.omega_damped / mode.omega - 1.0, -0.0404 * wh * wh, 2e-4);
}

}  // namespace
}  // namespace myo
