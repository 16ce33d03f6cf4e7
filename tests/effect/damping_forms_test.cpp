#include <gtest/gtest.h>

#include <numbers>

#include "dynamics/material_damping.hpp"
#include "plain_body.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"

namespace myo::effect {
namespace {

class DampingForms : public testing::TestWithParam<fem::ElementKind> {};

/// A slender bar that is let go decays by the sum of both times. What tet10 resists at its points is not damped: 2 % of
/// three layers.
TEST_P(DampingForms, AnExcessAddsToTheDeclaredDamping) {
    test::BeamSpec spec = test::slender_beam(GetParam());
    spec.poissons_ratio = 0.49;
    spec.damping_s = 1e-3;
    if (GetParam() == fem::ElementKind::tet10) spec.cells = {12, 3, 3};
    const test::HeldBeam beam = test::plain_body(spec);
    Affected affected = test::with_effect(beam, "extra_damping", {{"excess_damping_s", 2e-3}});
    test::hold_until_zero(affected.model, spec);
    const dynamics::NaturalMode mode = test::first_mode(beam.affected.model);
    const double step_s = 2.0 * std::numbers::pi / mode.omega_rad_s / 60.0;
    const Eigen::VectorXd q = test::ring(affected.model, mode, dynamics::Integrator::tr_bdf2, step_s, 60);
    ASSERT_GT(q.size(), 0);
    const double found = test::fit_oscillation(q, step_s).damping_ratio;
    const double expected = dynamics::damping_ratio(dynamics::slender_damping_factor(0.49), 3e-3, mode.omega_rad_s);
    test::record("relative_error", found / expected - 1.0);
    EXPECT_NEAR(found / expected, 1.0, 0.03);
}

INSTANTIATE_TEST_SUITE_P(OnTwoMeshes, DampingForms, testing::ValuesIn(test::two_kinds),
                         [](const auto& given) { return to_string(given.param); });

}  // namespace
}  // namespace myo::effect
