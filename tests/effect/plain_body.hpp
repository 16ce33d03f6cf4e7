#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "dynamics/simulate.hpp"
#include "dynamics/statics.hpp"
#include "support/beam.hpp"
#include "trial_context.hpp"

namespace myo::test {

/// Two meshes on which an effect has to do the same.
inline constexpr std::array two_kinds{fem::ElementKind::hex8, fem::ElementKind::tet10};

/// A beam without weight, damping, muscles and loads, held at its face x = 0 or, with spec.clamped false, nowhere.
inline HeldBeam plain_body(const BeamSpec& spec) {
    HeldBeam beam;
    beam.spec = spec;
    beam.affected.model = make_beam(spec);
    beam.context.body = beam.affected.model.body;
    beam.context.held = {{-1.0, -1.0, -1.0}, {1e-9, 1.0, 1.0}};
    beam.context.trial = "drop";
    return beam;
}

/// 10 x 1 x 1 of Poisson's ratio 0, as beam theory has it; twice as fine for hexahedra, whose edges are straight.
inline BeamSpec slender_beam(fem::ElementKind kind) {
    BeamSpec spec;
    spec.kind = kind;
    spec.cells = fem::cell_type(kind) == mesh::CellType::tet10 ? Eigen::Vector3i(10, 1, 1) : Eigen::Vector3i(20, 2, 2);
    spec.size = {0.1, 0.01, 0.01};
    spec.poissons_ratio = 0.0;
    return spec;
}

/// Deflection of its end under 1 N across it [m/N], shear included.
inline double end_compliance(const BeamSpec& spec) {
    const double L = spec.size(0), E = spec.youngs_modulus_Pa, G = 0.5 * E / (1.0 + spec.poissons_ratio);
    return L * L * L / (3.0 * E * second_moment(spec)) + L / (5.0 / 6.0 * G * section_area(spec));
}

inline Eigen::Matrix3Xd at_rest(const model::Model& model) {
    dynamics::SolverOptions options;
    options.tolerance = 1e-9;
    dynamics::StageSolver solver(model, options);
    Eigen::Matrix3Xd x = model.body->mesh.nodes;
    const dynamics::StageReport report = dynamics::solve_equilibrium(solver, 0.0, x);
    EXPECT_TRUE(report.ok()) << report.message;
    return x;
}

inline Eigen::Vector3d tip_at_rest(const HeldBeam& beam, const model::Model& model) {
    return tip_displacement(model, beam.spec, at_rest(model));
}

/// A run without errors worth speaking of.
inline dynamics::Trace fine_run(effect::Affected affected, double h_s, double end_s) {
    affected.options.h_s = h_s;
    affected.options.end_s = end_s;
    affected.options.solver.tolerance = 1e-8;
    dynamics::Trace trace = dynamics::simulate(affected.model, affected.options);
    EXPECT_TRUE(trace.complete()) << trace.message;
    return trace;
}

}  // namespace myo::test
