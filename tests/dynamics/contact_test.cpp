#include "model/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dynamics/energy.hpp"
#include "dynamics/simulate.hpp"
#include "dynamics/statics.hpp"
#include "model/loaded_face.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using test::BeamSpec;

constexpr double g_m_s2 = 9.81, rubbing_m_s = 4e-3, edge = 0.015;  // gravity, regularised speed, of the cells

/// A soft cube of 30 mm that nothing holds, on or above a plane through the origin, which is as stiff as a setup has
/// it: ten times the modulus over the cell's edge.
struct Cube {
    BeamSpec spec;
    model::DistanceField plane = model::plane_distance(Vector3d::Zero(), Vector3d::UnitZ());
    model::ContactLaw law;
    model::Model model;

    Cube(fem::ElementKind kind, double friction, double static_bed = 0.0) {
        spec.kind = kind;
        spec.cells = {2, 2, 2};
        spec.size = {0.03, 0.03, 0.03};
        spec.youngs_modulus_Pa = 1e5;
        spec.poissons_ratio = 0.45;
        spec.gravity_m_s2 = g_m_s2;
        spec.damping_s = 0.003;
        spec.clamped = false;
        law = {10.0 * spec.youngs_modulus_Pa / edge, 0.01 * edge, friction, rubbing_m_s, 0.01 * edge};
        law.static_bed_Pa_m = static_bed * law.stiffness_Pa_m;
        model = test::make_beam(spec);
        model.force_elements = {model::contact(*model.body, model::free_faces(*model.body), plane, law)};
    }

    /// Gravity as seen on a plane that falls along x at an angle.
    void incline(double angle) { model.gravity_m_s2 = g_m_s2 * Vector3d(std::sin(angle), 0.0, -std::cos(angle)); }

    Trace run(double h, double end, const Vector3d& velocity = Vector3d::Zero(), double above = 0.0) const {
        SimulationOptions options;
        options.h_s = h;
        options.end_s = end;
        options.initial.positions = model.body->mesh.nodes.colwise() + Vector3d(0.0, 0.0, above);
        options.initial.velocities = velocity.replicate(1, model.body->node_count());
        Trace trace = simulate(model, options);
        EXPECT_TRUE(trace.complete()) << trace.message;
        return trace;
    }

    Vector3d mean(const Matrix3Xd& field) const {
        const Eigen::VectorXd share = model.body->unit_mass * Eigen::VectorXd::Ones(field.cols());
        return field * share / share.sum();
    }
    double deepest(const Matrix3Xd& x) const {
        return model::deepest_penetration(*model.body, model::free_faces(*model.body), plane, x);
    }
};

class ObstacleContact : public testing::TestWithParam<fem::ElementKind> {};

/// Beyond the angle of friction a = g (sin - mu cos); below it the regularised law creeps at the speed where the
/// friction is the slope's pull, mu v / sqrt(v^2 + v0^2) = tan.
TEST_P(ObstacleContact, SlidesAndSticksOnAnInclineAsCoulombSays) {
    const double mu = 0.4, end = 0.3;
    Cube cube(GetParam(), mu);
    const double steep = 0.5, flat = 0.25;
    cube.incline(steep);
    const Trace slid = cube.run(0.005, end);
    const double a = g_m_s2 * (std::sin(steep) - mu * std::cos(steep));
    // In the second half, where the speed is far above v0.
    const std::size_t half = slid.times_s.size() / 2;
    const double gained = (cube.mean(slid.velocities.back()) - cube.mean(slid.velocities[half])).x() /
                          (a * (slid.times_s.back() - slid.times_s[half]));
    test::record("sliding_error", gained - 1.0);
    EXPECT_NEAR(gained, 1.0, 2e-3);
    cube.incline(flat);
    const double ratio = std::tan(flat) / mu, creep = rubbing_m_s * ratio / std::sqrt(1.0 - ratio * ratio);
    const Trace stuck = cube.run(0.005, end);
    const double crept = cube.mean(stuck.velocities.back()).x() / creep;
    test::record("creep_speed_error", crept - 1.0);
    EXPECT_NEAR(crept, 1.0, 0.02);
    EXPECT_LT(creep, rubbing_m_s);
}

/// A cube thrown at 3 m/s passes its own length in a step of 10 ms; the plane stops it all the same, it sinks in by
/// less than a fifth of a cell, and never has more energy than at first. A step of 10 ms through an impact may give
/// back some of what an earlier one took, below 0.5 % of the first energy; steps of 2 ms do not.
TEST_P(ObstacleContact, StopsWhatFallsFastAndAddsNoEnergy) {
    for (const double friction : {0.0, 0.4})
        for (const double h : {0.01, 0.002}) {
            const Cube cube(GetParam(), friction);
            const Trace trace = cube.run(h, 0.4, {0.5, 0.0, -3.0}, 0.02);
            if (!trace.complete()) continue;
            const auto mass = model::mass_matrix(cube.model);
            double rise = 0.0, before = 0.0, first = 0.0, largest = 0.0, deepest = 0.0;
            for (std::size_t k = 0; k < trace.times_s.size(); ++k) {
                const double now = energy(cube.model, mass, trace.positions[k], trace.velocities[k], trace.times_s[k])
                                       .total_J();
                if (k == 0) first = now;
                if (k > 0) rise = std::max(rise, (now - before) / first);
                before = now;
                largest = std::max(largest, now);
                deepest = std::max(deepest, cube.deepest(trace.positions[k]));
            }
            test::record("largest_rise_in_a_step", rise);
            test::record("largest_energy_ratio", largest / first);
            test::record("deepest_of_a_cell", deepest / edge);
            EXPECT_LE(largest, first * (1.0 + 1e-6)) << "friction " << friction << ", h " << h;
            EXPECT_LT(rise, h < 0.005 ? 1e-6 : 5e-3) << "friction " << friction << ", h " << h;
            EXPECT_LT(deepest, 0.2 * edge) << "friction " << friction << ", h " << h;
            EXPECT_GT(cube.mean(trace.positions.back()).z(), 0.0);
        }
}

/// At rest the cube sinks in by half the onset and its weight per area over the stiffness; it does so without anything
/// that holds it along the plane, and sticks to a slope.
TEST_P(ObstacleContact, BearsABodyAtRest) {
    Cube smooth(GetParam(), 0.0, 1e-7);
    StageSolver solver(smooth.model);
    Matrix3Xd x = smooth.model.body->mesh.nodes;
    const StageReport report = solve_equilibrium(solver, 0.0, x);
    ASSERT_TRUE(report.ok()) << report.message;
    EXPECT_LT(smooth.mean(x - smooth.model.body->mesh.nodes).head<2>().norm(), 1e-6);
    EXPECT_LT(smooth.deepest(x), 0.02 * edge);
    EXPECT_GT(smooth.deepest(x), 0.0);

    Cube rough(GetParam(), 0.4, 1e-7);
    rough.incline(0.25);
    StageSolver on_slope(rough.model);
    x = rough.model.body->mesh.nodes;
    const StageReport stuck = solve_equilibrium(on_slope, 0.0, x);
    ASSERT_TRUE(stuck.ok()) << stuck.message;
    const double slipped = rough.mean(x - rough.model.body->mesh.nodes).x();
    test::record("slipped_of_a_cell", slipped / edge);
    EXPECT_GT(slipped, 0.0);
    EXPECT_LT(slipped, 0.2 * edge);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ObstacleContact, testing::Values(fem::ElementKind::hex8, fem::ElementKind::tet10),
                         [](const auto& kind) { return to_string(kind.param); });

}  // namespace
}  // namespace myo::dynamics
