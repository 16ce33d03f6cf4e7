#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dynamics/statics.hpp"
#include "mesh/region.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"
#include "support/statics.hpp"

// Nodes that are held along some axes only: hinges and rollers.

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using model::GuidedNode;
using std::numbers::pi;

/// Nodes on the line across a section at mid-height.
std::vector<int> line_at(const mesh::VolumeMesh& mesh, const test::BeamSpec& spec, double x) {
    const double middle = 0.5 * spec.size(2);
    return mesh::nodes_in_box(mesh, {{x, 0.0, middle}, {x, spec.size(1), middle}});
}

/// The beam on a hinge at x = 0 and on a roller along x at its other end.
model::Model on_two_rollers(test::BeamSpec spec) {
    spec.clamped = false;
    model::Model model = test::make_beam(spec);
    const mesh::VolumeMesh mesh = model.body->mesh;
    std::vector<GuidedNode> guided;
    for (const int node : line_at(mesh, spec, 0.0)) guided.push_back({node, {true, false, true}});
    for (const int node : line_at(mesh, spec, spec.size(0))) guided.push_back({node, {false, false, true}});
    // One node of the hinge keeps the beam from moving aside, one of the roller from turning about z.
    guided.push_back({line_at(mesh, spec, 0.0).front(), {false, true, false}});
    guided.push_back({line_at(mesh, spec, spec.size(0)).front(), {false, true, false}});
    model.body = model::make_body(mesh, spec.kind, {}, {}, guided);
    return model;
}

test::BeamSpec slender(const char* element) {
    test::BeamSpec spec;
    spec.kind = test::element(element);
    spec.size = {0.4, 0.024, 0.02};
    spec.cells = spec.kind == fem::ElementKind::tet10 ? Eigen::Vector3i(30, 2, 2) : Eigen::Vector3i(40, 2, 2);
    spec.poissons_ratio = 0.0;
    return spec;
}

/// 5 q L^4 / (384 E I) + q L^2 / (8 k G A), k = 5 / 6 at nu = 0. Source: Timoshenko & Gere 1972, Mechanics of
/// materials.
double middle_deflection(const test::BeamSpec& spec) {
    const double q = spec.density_kg_m3 * spec.gravity_m_s2 * test::section_area(spec), E = spec.youngs_modulus_Pa,
                 L = spec.size(0), G = 0.5 * E;
    return 5.0 * q * std::pow(L, 4) / (384.0 * E * test::second_moment(spec)) +
           q * L * L / (8.0 * 5.0 / 6.0 * G * test::section_area(spec));
}

TEST(Rollers, CarryABeamThatSagsAsTheTextbookSays) {
    for (const char* element : {"hex8", "tet10"}) {
        test::BeamSpec spec = slender(element);
        spec.gravity_m_s2 = 1e-3;  // small strains
        const model::Model model = on_two_rollers(spec);
        const Matrix3Xd u = test::equilibrium(model) - model.body->mesh.nodes;
        const std::vector<int> middle = line_at(model.body->mesh, spec, 0.5 * spec.size(0));
        ASSERT_FALSE(middle.empty());
        const double error = -u(2, middle.front()) / middle_deflection(spec) - 1.0;
        test::record(std::string("error_") + element, error);
        EXPECT_LT(std::abs(error), 0.015) << element;
    }
}

/// Under a load along x, too: a roller takes what crosses it and nothing along its free axis.
TEST(Rollers, GiveNoForceAlongTheirFreeAxis) {
    test::BeamSpec spec = slender("hex8");
    spec.gravity_m_s2 = 0.3;
    model::Model model = on_two_rollers(spec);
    test::push_tip(model, spec, {0.02, 0.0, 0.0});
    const Matrix3Xd x = test::equilibrium(model);
    // What is left of all forces is the force of the supports.
    const model::Stiffness stiffness = model::stiffness(model);
    const std::vector<double> passive;
    model::InternalInput input;
    input.stiffness = &stiffness;
    input.activation = &passive;
    const Matrix3Xd left = model::internal_energy(model, x, input, model::HessianKind::none).gradient -
                           model::external_forces(model, model::mass_spans(model).front().mass, 0.0);
    const double weight = spec.density_kg_m3 * spec.size.prod() * spec.gravity_m_s2;
    Vector3d hinge = Vector3d::Zero(), roller = Vector3d::Zero();
    for (const int node : line_at(model.body->mesh, spec, 0.0)) hinge += left.col(node);
    for (const int node : line_at(model.body->mesh, spec, spec.size(0))) roller += left.col(node);
    EXPECT_NEAR(roller.z(), 0.5 * weight, 0.02 * weight);
    EXPECT_NEAR(roller.z() + hinge.z(), weight, 1e-6 * weight);
    EXPECT_NEAR(hinge.x(), -0.02, 1e-6 * 0.02);
    EXPECT_LT(std::abs(roller.x()), 1e-6 * 0.02);
    // Held coordinates do not move at all, the free one does.
    const std::vector<int> end = line_at(model.body->mesh, spec, spec.size(0));
    EXPECT_EQ(x(2, end.front()), model.body->mesh.nodes(2, end.front()));
    EXPECT_GT(std::abs(x(0, end.front()) - model.body->mesh.nodes(0, end.front())), 1e-5);
}

/// omega = pi^2 sqrt(E I / (rho A L^4)). Source: Blevins 1979, table 8-1; shear takes 0.5 % at this length.
TEST(Rollers, APinnedBeamRingsAtItsFirstFrequency) {
    for (const char* element : {"hex8", "tet10"}) {
        const test::BeamSpec spec = slender(element);
        const double beam = pi * pi *
                            std::sqrt(spec.youngs_modulus_Pa * test::second_moment(spec) /
                                      (spec.density_kg_m3 * test::section_area(spec) * std::pow(spec.size(0), 4)));
        const double error = test::first_mode(on_two_rollers(spec)).omega_rad_s / beam - 1.0;
        test::record(std::string("frequency_") + element, error);
        EXPECT_LT(std::abs(error), 0.012) << element;
    }
}

/// Held along all three axes is clamped, however it is said.
TEST(Rollers, HeldAlongAllAxesIsTheClamp) {
    test::BeamSpec spec;
    spec.gravity_m_s2 = 9.81;
    const model::Model clamped = test::make_beam(spec);
    model::Model guided = clamped;
    std::vector<GuidedNode> nodes;
    for (int i = 0; i < clamped.body->node_count(); ++i)
        if (clamped.body->clamped[static_cast<std::size_t>(i)]) {
            nodes.push_back({i, {true, false, true}});
            nodes.push_back({i, {false, true, false}});
        }
    guided.body = model::make_body(clamped.body->mesh, spec.kind, {}, {}, nodes);
    EXPECT_EQ(guided.body->clamped, clamped.body->clamped);
    EXPECT_TRUE(guided.body->guided.empty());
    EXPECT_EQ(test::equilibrium(guided), test::equilibrium(clamped));
}

/// Every way to solve the steps leads to the same motion.
TEST(Rollers, AllSolversAgree) {
    test::BeamSpec spec;
    spec.cells = {8, 2, 2};
    spec.gravity_m_s2 = 9.81;
    spec.damping_s = 0.002;
    const model::Model model = on_two_rollers(spec);
    SimulationOptions options;
    options.h_s = 0.005;
    options.end_s = 0.1;
    options.solver.tolerance = 1e-9;
    const auto last = [&](Strategy strategy, double entries) {
        SimulationOptions own = options;
        own.solver.strategy = strategy;
        if (entries > 0.0) own.solver.max_factor_entries = entries;
        const Trace trace = simulate(model, own);
        EXPECT_TRUE(trace.complete()) << trace.message;
        return trace.positions.back();
    };
    const Matrix3Xd usual = last(Strategy::automatic, 0.0);
    EXPECT_GT((usual - model.body->mesh.nodes).cwiseAbs().maxCoeff(), 5e-4);
    for (const Strategy strategy : {Strategy::newton, Strategy::projective})
        EXPECT_LT((last(strategy, 0.0) - usual).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT((last(Strategy::automatic, 1.0) - usual).cwiseAbs().maxCoeff(), 1e-6) << "Schwarz preconditioner";
}

}  // namespace
}  // namespace myo::dynamics
