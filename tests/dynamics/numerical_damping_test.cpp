#include "dynamics/numerical_damping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "support/figures.hpp"
#include "support/oscillation.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Complex = std::complex<double>;
using Eigen::VectorXd;

/// The first frequency of the paper's beam and its steps.
constexpr double omega = 2.0 * std::numbers::pi * 7.75;
using test::paper_steps;

TEST(Amplification, OfImplicitEulerIsThePapersFormula) {
    std::vector<double> ratios;
    for (const double h : paper_steps) {
        const DiscreteVibration vibration = discrete_vibration(Integrator::implicit_euler, {omega}, h);
        ratios.push_back(vibration.damping_ratio);
        EXPECT_NEAR(vibration.damping_ratio, implicit_euler_numerical_damping(omega, h), 1e-12) << h;
        EXPECT_NEAR(vibration.spectral_radius, 1.0 / std::hypot(1.0, omega * h), 1e-12) << h;
    }
    test::record("damping_ratios", ratios);
    EXPECT_NEAR(ratios[3], 0.229, 5e-4);
    EXPECT_EQ(implicit_euler_numerical_damping(omega, 0.0), 0.0);
}

/// Roots from the textbook: of x' = lambda x with lambda = s_exact, as all but implicit Euler with Lambda treat x and v
/// alike.
Complex textbook_root(const TimeScheme& scheme, Complex z) {
    switch (scheme.integrator) {
        case Integrator::implicit_euler: return 1.0 / (1.0 - z);
        case Integrator::trapezoidal: return (1.0 + 0.5 * z) / (1.0 - 0.5 * z);
        case Integrator::bdf2: return (2.0 + std::sqrt(1.0 + 2.0 * z)) / (3.0 - 2.0 * z);
        case Integrator::tr_bdf2: {
            const double gamma = 2.0 - std::sqrt(2.0), c1 = 1.0 / (gamma * (2.0 - gamma)),
                         c0 = (1.0 - gamma) * (1.0 - gamma) * c1;
            const Complex g = 0.5 * gamma * z;
            return (c1 * (1.0 + g) / (1.0 - g) - c0) / (1.0 - g);
        }
        case Integrator::generalized_alpha: {
            // y1 = y0 + h ((1 - g) d0 + g d1), am d1 + (1 - am) d0 = lambda (af y1 + (1 - af) y0) for (y, h d).
            const double r = scheme.rho_inf, am = 0.5 * (3.0 - r) / (1.0 + r), af = 1.0 / (1.0 + r), g = 0.5 + am - af;
            Eigen::Matrix2cd after, before;
            after << 1.0, -g, -af * z, am;
            before << 1.0, 1.0 - g, (1.0 - af) * z, am - 1.0;
            const auto [first, second] = test::step_eigenvalues(after.inverse() * before);
            return std::abs(first - std::exp(z)) < std::abs(second - std::exp(z)) ? first : second;
        }
    }
    return 0.0;
}

TEST(Amplification, OfEverySchemeIsTheTextbooks) {
    for (const auto& [name, scheme] : test::all_schemes())
        for (const double zeta : {0.0, 0.055})
            for (const double h : paper_steps) {
                const Complex exact = omega * Complex(-zeta, std::sqrt(1.0 - zeta * zeta));
                const Complex s = std::log(textbook_root(scheme, exact * h)) / h;
                const DiscreteVibration vibration = discrete_vibration(scheme, {omega, zeta}, h);
                EXPECT_NEAR(vibration.damping_ratio, -s.real() / std::abs(s), 1e-9) << name << " " << h;
                EXPECT_NEAR(vibration.frequency_error, s.imag() / exact.imag() - 1.0, 1e-9) << name << " " << h;
            }
}

TEST(Amplification, OfGeneralizedAlphaHasTheChosenRadiusAtInfinity) {
    for (const double rho : {0.0, 0.2, 0.5, 0.8, 1.0}) {
        const TimeScheme scheme{Integrator::generalized_alpha, rho};
        // It nears infinity as the root of omega h.
        EXPECT_NEAR(amplification(scheme, {1.0}, 3e3).eigenvalues().cwiseAbs().maxCoeff(), rho, 0.03) << rho;
        for (double wh = 0.01; wh < 100.0; wh *= 1.5)
            EXPECT_LE(amplification(scheme, {1.0}, wh).eigenvalues().cwiseAbs().maxCoeff(), 1.0 + 1e-9)
                << rho << " " << wh;
    }
    for (const double h : paper_steps) {
        const auto ratio = [&](const TimeScheme& scheme) {
            return discrete_vibration(scheme, {omega}, h).damping_ratio;
        };
        EXPECT_NEAR(ratio({Integrator::generalized_alpha, 0.0}), ratio(Integrator::bdf2), 1e-12);
        EXPECT_NEAR(ratio({Integrator::generalized_alpha, 1.0}), ratio(Integrator::trapezoidal), 1e-12);
    }
}

/// A step much too long for the vibration still has a damping ratio, and the strongly damping schemes extinguish it.
TEST(NumericalDamping, IsARatioAtEveryStep) {
    for (const Integrator scheme : {Integrator::tr_bdf2, Integrator::implicit_euler, Integrator::bdf2,
                                    Integrator::trapezoidal, Integrator::generalized_alpha})
        for (double wh = 1e-5; wh < 1e7; wh *= 3.0) {
            const double ratio = discrete_vibration(scheme, {wh / 0.01}, 0.01).damping_ratio;
            EXPECT_GT(ratio, -1e-9) << to_string(scheme) << " at omega h = " << wh;
            EXPECT_LE(ratio, 1.0) << to_string(scheme) << " at omega h = " << wh;
        }
    EXPECT_GT(discrete_vibration(Integrator::implicit_euler, {1e5}, 0.01).damping_ratio, 0.9);
}

TEST(NumericalDamping, OfTheImplicitEulerBeamFollowsThePapersFormula) {
    const model::Model model = test::held(test::ringing_beam());
    const NaturalMode mode = test::first_mode(model);
    std::vector<double> measured, errors;
    for (const double h : paper_steps) {
        const VectorXd q = test::ring(model, mode, Integrator::implicit_euler, h, 40);
        ASSERT_GT(q.size(), 0);
        measured.push_back(test::fit_oscillation(q, h).damping_ratio);
        errors.push_back(measured.back() / implicit_euler_numerical_damping(mode.omega_rad_s, h) - 1.0);
        EXPECT_LT(std::abs(errors.back()), 0.02) << h;
    }
    test::record("frequency_Hz", mode.omega_rad_s / (2.0 * std::numbers::pi));
    test::record("damping_ratios", measured);
    test::record("errors", errors);
}

/// All schemes at the paper's step of 10 ms, without and with damping of the material.
TEST(NumericalDamping, OfTheBeamIsThatOfTheAmplification) {
    for (const double damping_s : {0.0, 0.002}) {
        test::BeamSpec spec = test::ringing_beam();
        spec.damping_s = damping_s;
        const model::Model model = test::held(spec);
        const NaturalMode mode = test::first_mode(model);
        const double h = 0.01, zeta = 0.5 * damping_s * mode.omega_rad_s;
        for (const auto& [name, scheme] : test::all_schemes()) {
            const VectorXd q = test::ring(model, mode, scheme, h, 60);
            ASSERT_GT(q.size(), 0) << name;
            const test::Oscillation motion = test::fit_oscillation(q.tail(50),
                                                                   h);  // without the start of two-step schemes
            const DiscreteVibration expected = discrete_vibration(scheme, {mode.omega_rad_s, zeta}, h);
            const double frequency_error = motion.omega_damped / (mode.omega_rad_s * std::sqrt(1.0 - zeta * zeta)) -
                                           1.0;
            const std::string label = name + std::string(damping_s > 0.0 ? "_damped" : "");
            test::record(label + "_damping_ratio", motion.damping_ratio);
            test::record(label + "_expected", expected.damping_ratio);
            test::record(label + "_frequency_error", frequency_error);
            EXPECT_NEAR(motion.damping_ratio, expected.damping_ratio, 5e-5 + 0.01 * expected.damping_ratio) << label;
            EXPECT_NEAR(frequency_error, expected.frequency_error, 5e-4) << label;
            if (label == "tr_bdf2") {
                EXPECT_LE(std::abs(motion.damping_ratio), 0.002);
            }
        }
    }
}

}  // namespace
}  // namespace myo::dynamics
