#include <gtest/gtest.h>

#include "sensitivity/driven_beam.hpp"
#include "sensitivity/gradient_check.hpp"

namespace myo::sensitivity {
namespace {

/// The driven beam on a hinge and a roller, pushed by a force that grows.
model::Model rolling_beam(fem::ElementKind kind) {
    model::Model model = test::driven_beam(kind);
    const mesh::VolumeMesh mesh = model.body->mesh;
    std::vector<model::GuidedNode> guided;
    for (int i = 0; i < model.body->node_count(); ++i) {
        if (mesh.nodes(0, i) < 1e-6) guided.push_back({i, {true, mesh.nodes(2, i) < 1e-6, false}});
        if (mesh.nodes(2, i) < 1e-6 && (mesh.nodes(0, i) < 1e-6 || mesh.nodes(0, i) > 0.1 - 1e-6))
            guided.push_back({i, {false, true, true}});
    }
    model.body = model::make_body(mesh, kind, {}, {}, guided);
    model.forces.back().until_s = std::numeric_limits<double>::infinity();
    model.forces.back().course = {{0.0, 0.011, 0.011, 0.02}, {0.5, 1.0, 0.2, 0.8}};
    return model;
}

TEST(RollerGradient, EqualsCentralDifferencesForEveryParameter) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet10})
        for (const dynamics::StartKind start : {dynamics::StartKind::straight, dynamics::StartKind::equilibrium}) {
            const model::Model model = rolling_beam(kind);
            const dynamics::SimulationOptions options = test::short_run(dynamics::Integrator::tr_bdf2, start);
            const GradientCheck check = check_gradient(model, options, test::rough_loss(model),
                                                       checked_parameters(model, options));
            ASSERT_TRUE(check.complete()) << check.message;
            bool identical = true, any = false;
            for (const GradientCheckRow& row : check.rows) {
                EXPECT_LT(row.relative_error, 1e-5)
                    << row.name << ": adjoint " << row.adjoint << ", difference " << row.difference;
                identical = identical && row.adjoint == row.difference;
                any = any || row.adjoint != 0.0;
            }
            EXPECT_TRUE(any);
            EXPECT_FALSE(identical);
        }
}

}  // namespace
}  // namespace myo::sensitivity
