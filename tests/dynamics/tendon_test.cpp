#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/natural_modes.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/statics.hpp"
#include "support/tendon_body.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Vector3d;

/// A slender cantilever with a straight tendon `off_m` below its axis, through a guide at each section of nodes.
struct SlenderBeam {
    test::BeamSpec spec;
    model::Model model;
    std::vector<Vector3d> path;
    double off_m = 0.003;
};

SlenderBeam slender_beam(fem::ElementKind kind, const Eigen::Vector3i& cells) {
    SlenderBeam beam;
    beam.spec.kind = kind;
    beam.spec.size = {0.2, 0.01, 0.01};
    beam.spec.cells = cells;
    beam.spec.poissons_ratio = 0.3;
    beam.spec.material = "corotational";  // linear in the strain, as the theory is
    beam.model = test::make_beam(beam.spec);
    for (int i = 0; i <= 40; ++i) beam.path.emplace_back(0.005 * i, 0.005, 0.005 - beam.off_m);
    return beam;
}

/// A frictionless thread beside the axis, guided all along, carries the same tension everywhere: W(strain, curvature) +
/// T (1 + strain - e curvature) per length is stationary at EA strain = -T and EI curvature = T e, a circle for any
/// rotation of the end. Source: Camarillo et al. 2008, "Mechanics modeling of tendon-driven continuum manipulators".
TEST(Tendon, BendsASlenderBeamToACircle) {
    struct Run {
        const char* element;
        Eigen::Vector3i cells;
    };
    for (const Run& run : {Run{"hex8", {20, 1, 1}}, Run{"hex8", {40, 2, 2}}, Run{"hex8", {80, 4, 4}},
                           Run{"tet10", {20, 1, 1}}, Run{"tet10", {40, 2, 2}}}) {
        SlenderBeam beam = slender_beam(test::element(run.element), run.cells);
        const double EI = beam.spec.youngs_modulus_Pa * test::second_moment(beam.spec);
        const double curvature = 3.0, tension = EI * curvature / beam.off_m;
        test::pull_by_tension(beam.path, fibre::Signal::constant(tension), beam.model);
        const double strain = -tension / (beam.spec.youngs_modulus_Pa * test::section_area(beam.spec));
        const Vector3d tip = test::tip_at_equilibrium(beam.model, beam.spec);  // displacement of the end's centre
        const double angle = curvature * beam.spec.size(0);
        const double drop = -(1.0 - std::cos(angle)) / curvature * (1.0 + strain);
        const double reach = std::sin(angle) / curvature * (1.0 + strain) - beam.spec.size(0);
        const std::string mesh = std::string(run.element) + "_" + std::to_string(run.cells(2));
        test::record("drop_error_" + mesh, tip(2) / drop - 1.0);
        EXPECT_NEAR(tip(2) / drop, 1.0, 0.01) << mesh;
        EXPECT_NEAR(tip(0), reach, 0.01 * std::abs(drop)) << mesh;
    }
}

/// With capstan friction the curvature falls along the beam with the tension: theta' = k0 exp(-f theta), so that
/// exp(f theta) = 1 + f k0 s.
TEST(Tendon, BendsLessBeyondEachBendByFriction) {
    SlenderBeam beam = slender_beam(fem::ElementKind::hex8, {40, 2, 2});
    const double EI = beam.spec.youngs_modulus_Pa * test::second_moment(beam.spec);
    const double k0 = 3.0, friction = 0.5;
    test::pull_by_tension(beam.path, fibre::Signal::constant(EI * k0 / beam.off_m), beam.model, friction);
    const Vector3d tip = test::tip_at_equilibrium(beam.model, beam.spec);
    double drop = 0.0, without = 0.0;  // of the axis, by the midpoint rule
    const int parts = 1000;
    for (int i = 0; i < parts; ++i) {
        const double s = (i + 0.5) * beam.spec.size(0) / parts;
        drop -= std::sin(std::log(1.0 + friction * k0 * s) / friction) * beam.spec.size(0) / parts;
        without -= std::sin(k0 * s) * beam.spec.size(0) / parts;
    }
    EXPECT_GT(drop / without, 0.8);
    EXPECT_LT(drop / without, 0.95);
    EXPECT_NEAR(tip(2) / drop, 1.0, 0.015);
}

/// While the thread pays out, friction makes the tension rise along it instead.
TEST(Tendon, BendsMoreBeyondEachBendWhilePayingOut) {
    const auto drop_under = [](const fibre::Signal& tension_N, double friction) {
        SlenderBeam beam = slender_beam(fem::ElementKind::hex8, {20, 1, 1});
        test::pull_by_tension(beam.path, tension_N, beam.model, friction);
        return -test::tip_at_equilibrium(beam.model, beam.spec)(2);
    };
    const double without = drop_under(fibre::Signal::constant(0.3), 0.0);
    EXPECT_GT(drop_under({{-1.0, 1.0}, {0.4, 0.2}}, 0.3), 1.02 * without);
    EXPECT_LT(drop_under({{-1.0, 1.0}, {0.2, 0.4}}, 0.3), 0.98 * without);
}

/// Vibrations are those of the symmetric part of the stiffness: a little friction changes them little.
TEST(Tendon, LeavesVibrationsToTheSymmetricPart) {
    const auto omega_with = [](double friction) {
        SlenderBeam beam = slender_beam(fem::ElementKind::hex8, {20, 1, 1});
        test::pull_by_tension(beam.path, fibre::Signal::constant(0.3), beam.model, friction);
        StageSolver solver(beam.model);
        const NaturalModes modes = natural_modes(solver, test::equilibrium(beam.model), 2);
        EXPECT_TRUE(modes.ok()) << modes.residual;
        return modes.ok() ? modes.modes[0].omega_rad_s : 0.0;
    };
    EXPECT_NEAR(omega_with(0.3) / omega_with(0.0), 1.0, 0.05);
}

/// The thread that takes in a length pulls as hard as the one of that tension.
TEST(Tendon, ShortensAsItsTensionDoes) {
    SlenderBeam pulled = slender_beam(fem::ElementKind::hex8, {40, 2, 2}), taken_in = pulled;
    const double tension = 0.4;
    test::pull_by_tension(pulled.path, fibre::Signal::constant(tension), pulled.model);
    const Eigen::Matrix3Xd x = test::equilibrium(pulled.model);
    const double shortened = model::tendon_state(*pulled.model.force_elements.front(), {x}).shortening_m;
    EXPECT_GT(shortened, 0.002);
    const double stiffness = 4000.0;
    test::pull_by_shortening(taken_in.path, fibre::Signal::constant(shortened + tension / stiffness), stiffness,
                             taken_in.model);
    const Eigen::Matrix3Xd y = test::equilibrium(taken_in.model);
    EXPECT_LT((y - x).cwiseAbs().maxCoeff(), 2e-4 * (x - pulled.model.body->mesh.nodes).cwiseAbs().maxCoeff());
    EXPECT_NEAR(model::tendon_state(*taken_in.model.force_elements.front(), {y}).tension_N, tension, 1e-4 * tension);
}

/// A thread that pays out hangs loose: the body stays as it is.
TEST(Tendon, NeverPushes) {
    SlenderBeam beam = slender_beam(fem::ElementKind::hex8, {40, 2, 2});
    test::pull_by_shortening(beam.path, fibre::Signal::constant(-0.003), 4000.0, beam.model);
    const Eigen::Matrix3Xd x = test::equilibrium(beam.model);
    EXPECT_LT((x - beam.model.body->mesh.nodes).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace myo::dynamics
