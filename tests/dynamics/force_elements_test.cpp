#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/simulate.hpp"
#include "dynamics/statics.hpp"
#include "model/cavity_pressure.hpp"
#include "model/elastic_bed.hpp"
#include "model/loaded_face.hpp"
#include "model/surface_drag.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/hollow.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using test::BeamSpec;

/// A stiff block on a bed sinks by its weight over k A.
TEST(ElasticBed, CarriesAWeight) {
    BeamSpec spec;
    spec.kind = fem::ElementKind::tet10;
    spec.clamped = false;
    spec.youngs_modulus_Pa = 1e8;
    spec.poissons_ratio = 0.3;
    spec.gravity_m_s2 = 9.81;
    model::Model model = test::make_beam(spec);
    const model::Body& body = *model.body;
    std::vector<int> bottom;
    for (int i = 0; i < body.node_count(); ++i)
        if (body.mesh.nodes(2, i) < 1e-9) bottom.push_back(i);
    const double k = 2e6;
    model.force_elements = {model::elastic_bed(body, model::faces_of_nodes(body, bottom), k)};
    StageSolver solver(model);
    Matrix3Xd x = body.mesh.nodes;
    ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
    const double area = spec.size(0) * spec.size(1), weight = spec.density_kg_m3 * spec.size.prod() * 9.81;
    const Vector3d sunk = test::tip_displacement(model, spec, x);
    EXPECT_NEAR(-sunk(2) * k * area / weight, 1.0, 2e-3);  // the block itself gives a little
}

/// Lame's thick sphere: the inner radius grows by p a / E ((1 - 2 nu) a^3 + (1 + nu) b^3 / 2) / (b^3 - a^3).
TEST(CavityPressure, WidensAThickSphereAsLameSays) {
    const double a = 0.01, b = 0.03, E = 2e5, nu = 0.45, p = 20.0;
    std::vector<double> errors;
    for (const int cells : {9, 18}) {
        model::Model model = test::hollow_sphere(a, b, cells);
        const model::Body& body = *model.body;
        model.moduli = model::uniform_moduli(body.cell_count(), E, nu);
        std::vector<int> outside, inside;
        for (int i = 0; i < body.node_count(); ++i) {
            if (body.mesh.nodes.col(i).norm() > b - 1e-9) outside.push_back(i);
            if (body.mesh.nodes.col(i).norm() < a + 1e-9) inside.push_back(i);
        }
        model.force_elements = {
            model::cavity_pressure(body, model::closed_cavities(body).at(0), fibre::Signal::constant(p)),
            model::elastic_bed(body, model::faces_of_nodes(body, outside), 1.0)};
        StageSolver solver(model);
        Matrix3Xd x = body.mesh.nodes;
        ASSERT_TRUE(solve_equilibrium(solver, 0.0, x).ok());
        double grown = 0.0;
        for (const int i : inside) grown += (x.col(i).norm() - a) / static_cast<double>(inside.size());
        const double lame = p * a / E * ((1.0 - 2.0 * nu) * a * a * a + 0.5 * (1.0 + nu) * b * b * b) /
                            (b * b * b - a * a * a);
        errors.push_back(grown / lame - 1.0);
    }
    // Flat faces hold less than the sphere: the error falls with the square of their size.
    EXPECT_LT(std::abs(errors[1]), 0.07);
    EXPECT_LT(std::abs(errors[1]), 0.4 * std::abs(errors[0]));
    EXPECT_NEAR((4.0 * errors[1] - errors[0]) / 3.0, 0.0, 0.02);
    test::record("error_of_the_inner_radius", errors);
}

/// A body that moves as one is slowed as a point mass under quadratic drag: v = v0 / (1 + v0 c A t / m).
TEST(SurfaceDrag, SlowsAFlyingBlockAsAPointMass) {
    BeamSpec spec;
    spec.clamped = false;
    spec.youngs_modulus_Pa = 1e7;
    spec.poissons_ratio = 0.3;
    const double c = 200.0, v0 = 1.0, end = 0.1;
    model::Model model = test::make_beam(spec);
    std::vector<int> faces(static_cast<std::size_t>(model.body->boundary.count()));
    for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = static_cast<int>(f);
    model.force_elements = {model::surface_drag(*model.body, faces, 0.0, c)};
    SimulationOptions options;
    options.h_s = 0.002;
    options.end_s = end;
    options.initial.velocities = Vector3d(0.0, 0.0, v0).replicate(1, model.body->node_count());
    const Trace trace = simulate(model, options);
    ASSERT_TRUE(trace.complete()) << trace.message;
    const double area = 2.0 * (spec.size(0) * spec.size(1) + spec.size(1) * spec.size(2) + spec.size(0) * spec.size(2));
    const double rate = v0 * c * area / (spec.density_kg_m3 * spec.size.prod());
    EXPECT_GT(rate * end, 2.0);
    const double travelled = std::log(1.0 + rate * end) * v0 / rate;
    const Vector3d moved = (trace.positions.back() - model.body->mesh.nodes).rowwise().mean();
    EXPECT_NEAR(moved(2) / travelled, 1.0, 2e-3);
}

}  // namespace
}  // namespace myo::dynamics
