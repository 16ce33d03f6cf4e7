#include <gtest/gtest.h>

#include <string>

#include "fibre/direction_field.hpp"
#include "fibre/fibres_along_line.hpp"
#include "fibre/painted_mask.hpp"
#include "mesh/region.hpp"
#include "sensitivity/driven_beam.hpp"
#include "sensitivity/gradient_check.hpp"
#include "sensitivity/tangent_run.hpp"
#include "support/figures.hpp"

namespace myo::sensitivity {
namespace {

/// The driven beam with a painted muscle, its lines turning along the beam, shares between 0 and 1, and one along a
/// bent line.
model::Model painted_beam(fem::ElementKind kind) {
    model::Model model = test::driven_beam(kind);
    const mesh::VolumeMesh& mesh = model.body->mesh;
    const fibre::Polyline arc{
        (Eigen::Matrix3Xd(3, 3) << 0.0, 0.05, 0.1, 0.005, 0.005, 0.02, 0.005, 0.008, 0.02).finished()};
    const Eigen::VectorXd weights = mesh::volume_fractions(mesh, Box{{0.01, 0, 0}, {0.08, 0.02, 0.03}});
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    fibres->push_back(fibre::fibres_of_mask(
        mesh, fibre::mask_of_cells(mesh, {weights, fibre::directions_along(mesh, arc)}), 8e4, "painted"));
    fibres->push_back(fibre::fibres_along_line(mesh, arc, 0.006, 2e5, "line"));
    model.fibres = fibres;
    return model;
}

/// The direction in each cell as a free vector, moved by a field that differs from cell to cell.
CheckedParameter directions_of(const model::Model& model, std::size_t group) {
    const Eigen::Matrix3Xd field = test::rough_field(model.body->cell_count(), 0.7);
    return {"directions of " + (*model.fibres)[group].name, 1e-3,
            [=](model::Model& m, dynamics::SimulationOptions&, double by) {
                auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>(*m.fibres);
                fibre::FibreGroup& changed = (*fibres)[group];
                for (std::size_t k = 0; k < changed.points.size(); ++k)
                    changed.points[k].shape += by * (changed.gradients[k] * field.col(changed.points[k].cell));
                m.fibres = fibres;
            },
            [&model, field, group](const ModelGradient& g) {
                return fibre_direction_gradient(model, g, group).cwiseProduct(field).sum();
            }};
}

class PaintedFibres : public testing::TestWithParam<fem::ElementKind> {};

TEST_P(PaintedFibres, AdjointEqualsDifferencesForDirectionsStiffnessAndSignals) {
    const model::Model model = painted_beam(GetParam());
    const dynamics::SimulationOptions options = test::short_run(dynamics::Integrator::tr_bdf2,
                                                                dynamics::StartKind::straight);
    std::vector<CheckedParameter> parameters = checked_parameters(model, options);
    parameters.push_back(directions_of(model, 0));
    parameters.push_back(directions_of(model, 1));
    const GradientCheck check = check_gradient(model, options, test::rough_loss(model), parameters);
    ASSERT_TRUE(check.complete()) << check.message;
    for (const GradientCheckRow& row : check.rows) {
        EXPECT_NE(row.adjoint, 0.0) << row.name;
        EXPECT_LT(row.relative_error, 1e-5)
            << row.name << ": adjoint " << row.adjoint << ", difference " << row.difference;
    }
    test::record("worst_error", check.worst_error());
}

TEST_P(PaintedFibres, TangentAlongASignalEqualsTheAdjoint) {
    model::Model model = painted_beam(GetParam());
    model.activation = {fibre::Signal::step(0.0, 1.0, 0.9), fibre::Signal::step(0.0, 1.0, 1.1)};
    dynamics::SimulationOptions options = test::short_run(dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight);
    options.solver.tangent_tolerance = 1e-12;
    const LossOfMotion loss = test::rough_loss(model);
    AdjointOptions adjoint;
    adjoint.tolerance = 1e-12;
    const GradientRun run = simulate_with_gradient(model, options, loss, adjoint);
    ASSERT_TRUE(run.complete()) << run.message;
    std::vector<ModelTangent> levels(2);
    for (std::size_t g = 0; g < 2; ++g)
        for (std::size_t other = 0; other < 2; ++other)
            levels[g].activation.push_back(fibre::Signal::step(0.0, 0.0, other == g ? 1.0 : 0.0));
    const SensitiveTrace tangents = simulate_with_tangents(model, options, levels, loss.nodes);
    const MotionLoss derivative = loss.evaluate(run.motion);
    for (std::size_t g = 0; g < 2; ++g) {
        const double along = test::along(derivative, tangents.tangents[g]);
        EXPECT_NE(along, 0.0);
        EXPECT_NEAR(run.gradient.activation[g][1] / along, 1.0, 1e-7) << g;
    }
}

INSTANTIATE_TEST_SUITE_P(All, PaintedFibres,
                         testing::Values(fem::ElementKind::hex8, fem::ElementKind::tet10, fem::ElementKind::tet4),
                         [](const testing::TestParamInfo<fem::ElementKind>& of) { return to_string(of.param); });

}  // namespace
}  // namespace myo::sensitivity
