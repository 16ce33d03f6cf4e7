#include "setup/integration_check.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "dynamics/material_damping.hpp"
#include "dynamics/numerical_damping.hpp"
#include "support/beam.hpp"

namespace myo::setup {
namespace {

constexpr double h = 0.01;

model::Model beam(double damping_s, double velocity_force_1_s) {
    test::BeamSpec spec;
    spec.cells = {7, 2, 2};
    spec.size = {0.1, 0.036, 0.03};
    spec.damping_s = damping_s;
    model::Model model = test::make_beam(spec);
    model.velocity_force_1_s = velocity_force_1_s;
    return model;
}

TEST(IntegrationCheck, OfImplicitEulerHasThePapersClosedForms) {
    const double damping = 0.002;
    const IntegrationCheck check = check_integration(beam(damping, 1.0), dynamics::Integrator::implicit_euler, h);
    const double omega = 2.0 * std::numbers::pi * check.frequency_Hz,
                 zeta = dynamics::damping_ratio(check.damping_factor, damping, omega);
    EXPECT_NEAR(check.frequency_Hz, 7.7, 0.5);
    EXPECT_NEAR(check.damping_ratio, zeta, 1e-12);
    EXPECT_NEAR(check.damping_factor, dynamics::slender_damping_factor(0.499), 0.005);
    EXPECT_NEAR(check.numerical_damping_ratio, dynamics::implicit_euler_numerical_damping(omega, h), 1e-9);
    ASSERT_TRUE(check.critical_velocity_force_1_s.has_value());
    EXPECT_FALSE(check.of_one_mode);
    EXPECT_NEAR(*check.critical_velocity_force_1_s / dynamics::implicit_euler_critical_velocity_force(omega, h, zeta),
                1.0, 0.01);
    ASSERT_EQ(check.warnings.size(), 1u);  // it damps far more than the material
    EXPECT_NE(check.warnings[0].find("damps the first vibration"), std::string::npos) << check.warnings[0];
}

TEST(IntegrationCheck, WarnsOnlyAboveTheCriticalVelocityForce) {
    for (const dynamics::Integrator scheme :
         {dynamics::Integrator::implicit_euler, dynamics::Integrator::tr_bdf2, dynamics::Integrator::bdf2}) {
        const double critical = check_integration(beam(0.002, 1.0), scheme, h).critical_velocity_force_1_s.value();
        for (const double factor : {0.97, 1.03}) {
            const IntegrationCheck check = check_integration(beam(0.002, factor * critical), scheme, h);
            bool warned = false;
            for (const std::string& warning : check.warnings)
                warned = warned || warning.find("Λ_crit") != std::string::npos;
            EXPECT_EQ(warned, factor > 1.0) << to_string(scheme);
        }
    }
    EXPECT_FALSE(
        check_integration(beam(0.002, 0.0), dynamics::Integrator::bdf2, h).critical_velocity_force_1_s.has_value());
}

TEST(IntegrationCheck, SaysNothingOfTheDefaultScheme) {
    for (const double damping : {0.0, 0.003}) {
        const IntegrationCheck check = check_integration(beam(damping, 0.0), dynamics::TimeScheme(), h);
        EXPECT_TRUE(check.warnings.empty()) << check.warnings.front();
        EXPECT_LE(std::abs(check.numerical_damping_ratio), 0.002);
    }
}

/// Nothing holds it: it has no first vibration, and the check says nothing rather than something wrong.
TEST(IntegrationCheck, OfAFreeBodyIsEmpty) {
    test::BeamSpec spec;
    spec.clamped = false;
    const IntegrationCheck check = check_integration(test::make_beam(spec), dynamics::TimeScheme(), h);
    EXPECT_EQ(check.frequency_Hz, 0.0);
    EXPECT_TRUE(check.warnings.empty());
}

}  // namespace
}  // namespace myo::setup
