#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "dynamics/natural_modes.hpp"
#include "plain_body.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"

namespace myo::effect {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

class ForceForms : public testing::TestWithParam<fem::ElementKind> {};

/// A stiff cube that nothing holds: it moves as a point does.
test::HeldBeam cube(fem::ElementKind kind) {
    test::BeamSpec spec;
    spec.kind = kind;
    spec.cells = {2, 2, 2};
    spec.size = {0.03, 0.03, 0.03};
    spec.youngs_modulus_Pa = 1e8;
    spec.poissons_ratio = 0.3;
    spec.clamped = false;
    return test::plain_body(spec);
}

constexpr double face_m2 = 9e-4, cube_kg = 1070.0 * 2.7e-5;

Vector3d mean_velocity(const model::Model& model, const Matrix3Xd& v) {
    const VectorXd volume = model.body->unit_mass * VectorXd::Ones(v.cols());
    return v * volume / volume.sum();
}

/// Mean velocities along x of a cube thrown at 1 m/s, after every millisecond.
std::vector<double> thrown(test::HeldBeam beam, const std::string& id, const EffectParameters& parameters) {
    Affected affected = test::with_effect(beam, id, parameters);
    affected.options.initial.velocities = Vector3d::UnitX().replicate(1, beam.context.body->node_count());
    const dynamics::Trace trace = test::fine_run(affected, 1e-3, 0.1);
    std::vector<double> v;
    for (const Matrix3Xd& velocities : trace.velocities) v.push_back(mean_velocity(affected.model, velocities).x());
    return v;
}

/// m v' = -c A v over the whole surface.
TEST_P(ForceForms, LinearDragSlowsAThrownCubeByItsExponential) {
    const double c = 50.0, rate = c * 6.0 * face_m2 / cube_kg;
    const std::vector<double> v = thrown(cube(GetParam()), "linear_drag", {{"coefficient_Pa_s_m", c}});
    double worst = 0.0;
    for (std::size_t k = 0; k < v.size(); ++k)
        worst = std::max(worst, std::abs(v[k] - std::exp(-rate * 1e-3 * static_cast<double>(k))));
    test::record("worst", worst);
    EXPECT_LT(worst, 2e-4);
    EXPECT_LT(v.back(), 0.5);
}

/// m v' = -c A v^2.
TEST_P(ForceForms, QuadraticDragSlowsAThrownCubeByItsHyperbola) {
    const double c = 100.0, rate = c * 6.0 * face_m2 / cube_kg;
    const std::vector<double> v = thrown(cube(GetParam()), "quadratic_drag", {{"coefficient_kg_m3", c}});
    double worst = 0.0;
    for (std::size_t k = 0; k < v.size(); ++k)
        worst = std::max(worst, std::abs(v[k] - 1.0 / (1.0 + rate * 1e-3 * static_cast<double>(k))));
    test::record("worst", worst);
    EXPECT_LT(worst, 5e-4);
    EXPECT_LT(v.back(), 0.5);
}

/// m v' = -F v / s with s^2 = v^2 + v0^2: s - v0 asinh(v0 / v) falls by F/m in time. Behind a wall that only slides
/// across it, the same force does nothing to a cube thrown against it.
TEST_P(ForceForms, DryFrictionSlowsAThrownCubeByItsLaw) {
    const double F = 0.2, v0 = 4e-3;
    const auto potential = [&](double v) { return std::hypot(v, v0) - v0 * std::asinh(v0 / v); };
    EffectParameters friction{{"friction_force_N", F}, {"position_m", VectorXd(Vector3d(0.03, 0.015, 0.015))}};
    const std::vector<double> v = thrown(cube(GetParam()), "dry_friction", friction);
    double worst = 0.0;
    for (std::size_t k = 0; k < v.size(); ++k)
        worst = std::max(worst,
                         std::abs(potential(v[k]) - potential(1.0) + F / cube_kg * 1e-3 * static_cast<double>(k)));
    test::record("worst", worst);
    EXPECT_LT(worst, 2e-3);
    EXPECT_LT(v.back(), 0.5);
    friction["normal"] = VectorXd(Vector3d::UnitX());
    EXPECT_NEAR(thrown(cube(GetParam()), "dry_friction", friction).back(), 1.0, 1e-9);
}

/// v' = -omega^2 (x - gap) beyond the gap: half a cosine, after which the cube flies back as fast as it came.
TEST_P(ForceForms, AnEndStopThrowsACubeBack) {
    const double k = 300.0, gap = 0.02, omega = std::sqrt(k / cube_kg), meets = gap / 1.0;
    const std::vector<double> v = thrown(cube(GetParam()), "end_stop",
                                         {{"stiffness_N_m", k},
                                          {"gap_m", gap},
                                          {"normal", VectorXd(-2.0 * Vector3d::UnitX())},
                                          {"position_m", VectorXd(Vector3d(0.03, 0.015, 0.015))}});
    double worst = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const double phase = std::clamp(omega * (1e-3 * static_cast<double>(i) - meets), 0.0, std::numbers::pi);
        worst = std::max(worst, std::abs(v[i] - std::cos(phase)));
    }
    test::record("worst", worst);
    EXPECT_LT(worst, 5e-3);
    EXPECT_LT(v.back(), -0.99);
}

/// The fluid before and behind the cube falls with it and weighs nothing; that beside it slips.
TEST_P(ForceForms, AddedMassLetsACubeFallAsMuchSlower) {
    test::HeldBeam beam = cube(GetParam());
    beam.affected.model.gravity_m_s2 = {0.0, 0.0, -9.81};
    const double per_area = 20.0, step_s = 2e-3, end = 0.1;
    const Affected affected = test::with_effect(beam, "added_mass", {{"surface_density_kg_m2", per_area}});
    const dynamics::Trace trace = test::fine_run(affected, step_s, end);
    const double expected = -9.81 * cube_kg / (cube_kg + 2.0 * per_area * face_m2) * end;
    const double found = mean_velocity(affected.model, trace.velocities.back()).z();
    test::record("relative_error", found / expected - 1.0);
    EXPECT_NEAR(found / expected, 1.0, 1e-4);
    EXPECT_LT(std::abs(expected), 0.5 * 9.81 * end);
}

VectorXd end_centre(const test::BeamSpec& spec) {
    return Vector3d(spec.size(0), 0.5 * spec.size(1), 0.5 * spec.size(2));
}

/// (beta L)^2 of a cantilever with a mass at its end, mu times its own: 1 + cos cosh + mu beta (cos sinh - sin cosh) =
/// 0.
double squared_root(double mu) {
    const auto f = [mu](double b) {
        return 1.0 + std::cos(b) * std::cosh(b) + mu * b * (std::cos(b) * std::sinh(b) - std::sin(b) * std::cosh(b));
    };
    double low = 0.1, high = 1.88;  // the first root without a mass is 1.8751
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) > 0.0 ? low : high) = middle;
    }
    return low * low;
}

std::vector<double> frequencies(const model::Model& model, int count, double at_s = 0.0) {
    dynamics::StageSolver solver(model);
    const dynamics::NaturalModes found = dynamics::natural_modes(solver, model.body->mesh.nodes, count, at_s);
    EXPECT_TRUE(found.ok());
    std::vector<double> omega;
    for (const dynamics::NaturalMode& mode : found.modes) omega.push_back(mode.omega_rad_s);
    return omega;
}

TEST_P(ForceForms, APointMassWeighsDownAndSlowsTheEndOfABeam) {
    const test::BeamSpec spec = test::slender_beam(GetParam());
    test::HeldBeam beam = test::plain_body(spec);
    const double body_kg = spec.density_kg_m3 * spec.size.prod(), mu = 0.5;
    const Affected heavy = test::with_effect(beam, "point_mass",
                                             {{"mass_kg", mu * body_kg}, {"position_m", end_centre(spec)}});
    const double ratio = frequencies(heavy.model, 1)[0] / frequencies(beam.affected.model, 1)[0],
                 expected = squared_root(mu) / squared_root(0.0);
    test::record("frequency_ratio_error", ratio / expected - 1.0);
    EXPECT_NEAR(ratio / expected, 1.0, 5e-3);

    // Its weight, on a body that has next to none.
    beam.affected.model.density_kg_m3 = 1e-3;
    beam.affected.model.gravity_m_s2 = {0.0, 0.0, -9.81};
    const double kg = 2e-5;
    const Affected weighed = test::with_effect(beam, "point_mass", {{"mass_kg", kg}, {"position_m", end_centre(spec)}});
    const double sag = test::tip_at_rest(beam, weighed.model).z() / (-9.81 * kg * test::end_compliance(spec));
    test::record("sag_error", sag - 1.0);
    EXPECT_NEAR(sag, 1.0, 0.01);
}

/// A spring in parallel to the beam's own, that is loose at rest.
TEST_P(ForceForms, ACableTugStiffensTheEndOfABeam) {
    const test::BeamSpec spec = test::slender_beam(GetParam());
    test::HeldBeam beam = test::plain_body(spec);
    const double own = 1.0 / test::end_compliance(spec);
    const VectorXd anchor = end_centre(spec) + 1.0 * Vector3d::UnitZ();
    const EffectParameters cable{{"stiffness_N_m", 2.0 * own}, {"position_m", end_centre(spec)}, {"anchor_m", anchor}};
    EXPECT_LT(test::tip_at_rest(beam, test::with_effect(beam, "cable_tug", cable).model).norm(), 1e-12);
    test::push_tip(beam.affected.model, spec, {0.0, 0.0, 1e-3 * own});
    const double found = test::tip_at_rest(beam, test::with_effect(beam, "cable_tug", cable).model).z();
    test::record("relative_error", found / (1e-3 / 3.0) - 1.0);
    EXPECT_NEAR(found / (1e-3 / 3.0), 1.0, 0.01);
    // Along the beam it only turns, to the first order.
    const EffectParameters along{{"stiffness_N_m", 2.0 * own},
                                 {"position_m", end_centre(spec)},
                                 {"anchor_m", VectorXd(end_centre(spec) + 1.0 * Vector3d::UnitX())}};
    EXPECT_NEAR(test::tip_at_rest(beam, test::with_effect(beam, "cable_tug", along).model).z() /
                    test::tip_at_rest(beam, beam.affected.model).z(),
                1.0, 3e-3);
}

TEST_P(ForceForms, ABodyOnAThreadSlowsTheVibrationAlongItAlone) {
    const test::BeamSpec spec = test::slender_beam(GetParam());
    test::HeldBeam beam = test::plain_body(spec);
    const double body_kg = spec.density_kg_m3 * spec.size.prod(), mu = 0.6, ratio = 0.5, g = 9.80665;
    test::push_tip(beam.affected.model, spec, {0.0, 0.0, -mu / ratio * body_kg * g});
    const Affected hung = test::with_effect(beam, "hung_mass", {{"inertia_ratio", ratio}});
    const std::vector<double> bare = frequencies(beam.affected.model, 2), slowed = frequencies(hung.model, 2);
    const double expected = squared_root(mu) / squared_root(0.0);
    test::record("along_error", slowed[0] / bare[0] / expected - 1.0);
    test::record("across_error", slowed[1] / bare[1] - 1.0);
    EXPECT_NEAR(slowed[0] / bare[0] / expected, 1.0, 5e-3);
    EXPECT_NEAR(slowed[1] / bare[1], 1.0, 2e-3);
}

/// Frequency of the end's motion within [from_s, until_s], about wherever it swings.
double swing_rad_s(const test::HeldBeam& beam, const dynamics::Trace& trace, double from_s, double until_s) {
    std::vector<double> z;
    for (std::size_t k = 0; k < trace.times_s.size(); ++k)
        if (trace.times_s[k] > from_s - 1e-9 && trace.times_s[k] < until_s + 1e-9)
            z.push_back(test::tip_displacement(beam.affected.model, beam.spec, trace.positions[k]).z());
    const VectorXd all = Eigen::Map<const VectorXd>(z.data(), static_cast<Eigen::Index>(z.size()));
    const VectorXd changes = all.tail(all.size() - 1) - all.head(all.size() - 1);
    return test::fit_oscillation(changes, trace.times_s[1] - trace.times_s[0]).omega_damped;
}

/// The body hangs from 1 s to 3 s; before and after that nothing of it is left.
TEST_P(ForceForms, ABodyOnAThreadSwingsAlongAsLongAsItHangs) {
    test::BeamSpec spec = test::slender_beam(GetParam());
    spec.damping_s = 4e-3;  // takes away the faster vibrations
    test::HeldBeam beam = test::plain_body(spec);
    const double body_kg = spec.density_kg_m3 * spec.size.prod(), mu = 0.6, ratio = 40.0, step_s = 5e-3, comes_s = 1.0,
                 goes_s = 3.0, end_s = 4.0;
    test::push_tip(beam.affected.model, spec, {0.0, 0.0, -mu / ratio * body_kg * 9.80665});
    beam.affected.model.forces.back().from_s = comes_s;
    beam.affected.model.forces.back().until_s = goes_s;
    test::push_tip(beam.affected.model, spec, {0.0, 0.0, 1e-3});  // let go at the start, sets it swinging
    beam.affected.model.forces.back().until_s = 0.0;
    beam.affected.options.start = dynamics::StartKind::equilibrium;
    beam.affected.options.end_s = end_s;
    const Affected hung = test::with_effect(beam, "hung_mass", {{"inertia_ratio", ratio}});
    ASSERT_EQ(hung.model.directional_masses.size(), 1u) << "what is let go at the start has no inertia in the run";
    const double free_rad_s = frequencies(beam.affected.model, 1)[0],
                 slowed_rad_s = free_rad_s * squared_root(mu) / squared_root(0.0);
    EXPECT_NEAR(frequencies(hung.model, 1, comes_s)[0] / slowed_rad_s, 1.0, 5e-3);
    EXPECT_NEAR(frequencies(hung.model, 1, goes_s)[0] / free_rad_s, 1.0, 1e-9);
    const dynamics::Trace trace = test::fine_run(hung, step_s, end_s);
    ASSERT_TRUE(trace.complete());
    const double before = swing_rad_s(beam, trace, 0.4, comes_s),
                 during = swing_rad_s(beam, trace, comes_s + 0.6, goes_s),
                 after = swing_rad_s(beam, trace, goes_s + 0.4, end_s);
    test::record("errors", {before / free_rad_s - 1.0, during / slowed_rad_s - 1.0, after / free_rad_s - 1.0});
    EXPECT_LT(slowed_rad_s, 0.7 * free_rad_s);
    EXPECT_NEAR(before / free_rad_s, 1.0, 0.01);
    EXPECT_NEAR(during / slowed_rad_s, 1.0, 0.01);
    EXPECT_NEAR(after / free_rad_s, 1.0, 0.01);
}

/// The side that a beam of square section sags to is that of gravity, and it sags as far as its weight per length bends
/// it.
TEST_P(ForceForms, ATiltTurnsTheSagOfASquareBeam) {
    test::BeamSpec spec = test::slender_beam(GetParam());
    spec.gravity_m_s2 = 0.981;  // small motions
    const test::HeldBeam beam = test::plain_body(spec);
    const double degrees = 7.0, angle = degrees * std::numbers::pi / 180.0;
    const Affected tilted = test::with_effect(beam, "gravity_tilt",
                                              {{"tilt_deg", degrees}, {"axis", VectorXd(Vector3d::UnitX())}});
    const Vector3d tip = test::tip_at_rest(beam, tilted.model);
    const double L = spec.size(0), E = spec.youngs_modulus_Pa, A = section_area(spec),
                 load = spec.density_kg_m3 * spec.gravity_m_s2 * A;
    const double sag = load * std::pow(L, 4) / (8.0 * E * second_moment(spec)) +
                       0.5 * load * L * L / (5.0 / 6.0 * 0.5 * E * A);
    test::record("angle_error_deg", (std::atan2(tip.y(), -tip.z()) - angle) * 180.0 / std::numbers::pi);
    test::record("sag_error", tip.tail<2>().norm() / sag - 1.0);
    EXPECT_NEAR(std::atan2(tip.y(), -tip.z()), angle, 0.01 * angle);
    EXPECT_NEAR(tip.tail<2>().norm() / sag, 1.0, 0.015);
    // About a line across the beam its weight pulls it along.
    const Affected hanging = test::with_effect(beam, "gravity_tilt",
                                               {{"tilt_deg", 90.0}, {"axis", VectorXd(Vector3d::UnitY())}});
    EXPECT_NEAR(
        test::tip_at_rest(beam, hanging.model).x() / (-0.5 * spec.density_kg_m3 * spec.gravity_m_s2 * L * L / E), 1.0,
        2e-3);
}

INSTANTIATE_TEST_SUITE_P(OnTwoMeshes, ForceForms, testing::ValuesIn(test::two_kinds),
                         [](const auto& given) { return to_string(given.param); });

}  // namespace
}  // namespace myo::effect
