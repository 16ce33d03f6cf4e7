#include <gtest/gtest.h>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/diagnosis_context.hpp"
#include "mesh/box_mesh.hpp"
#include "support/figures.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

// Bodies of quadratic tetrahedra have the finer element where an effect varies within cells, declared or tried.

namespace myo::diagnosis {
namespace {

/// The swung beam on the element's cells, with what is added to its declaration.
setup::Setup beam_of(const test::Folder& folder, fem::ElementKind element, const std::string& added = "") {
    test::swung_beam(folder, 0.1);
    folder.write("experiment.toml", test::swung_beam_toml() + added);
    const Result<experiment::Experiment> experiment = experiment::read_experiment(folder.path());
    EXPECT_TRUE(experiment) << experiment.error().text();
    const Box box{Eigen::Vector3d::Zero(), {0.1, 0.03, 0.03}};
    setup::BodyMesh mesh;
    mesh.element = element;
    mesh.resolution_m = 0.03;
    mesh.mesh = fem::cell_type(element) == mesh::CellType::hex8
                    ? mesh::box_hex_mesh(box, {3, 1, 1})
                    : mesh::tet_box_mesh(box, {3, 1, 1}, fem::cell_type(element));
    Result<setup::Setup> setup = setup::prepare_setup(*experiment, {}, {}, &mesh);
    EXPECT_TRUE(setup) << setup.error().text();
    return std::move(*setup);
}

constexpr const char* patch = R"([[effect]]
id = "soft_patch"
relative_change = -0.3
centre_m = [0.05, 0.015, 0.015]
radius_m = 0.01
)";

TEST(CandidateElement, IsFineWhereADeclaredEffectVariesWithinCells) {
    const test::Folder folder("fine_declared");
    EXPECT_EQ(beam_of(folder, fem::ElementKind::tet10).body->kind, fem::ElementKind::tet10);
    const setup::Setup setup = beam_of(folder, fem::ElementKind::tet10, patch);
    EXPECT_EQ(setup.body->kind, fem::ElementKind::tet10_fine);
    EXPECT_EQ(setup.mesh.element, fem::ElementKind::tet10);  // as it was asked for
    for (const setup::PreparedTrial& trial : setup.trials) EXPECT_EQ(trial.model.body, setup.body);
    EXPECT_EQ(beam_of(folder, fem::ElementKind::hex8, patch).body->kind, fem::ElementKind::hex8);
}

TEST(CandidateElement, IsFineInADiagnosisThatMayNameSuchAnEffect) {
    const test::Folder folder("fine_tried");
    const setup::Setup setup = beam_of(folder, fem::ElementKind::tet10);
    const setup::Setup tried = for_candidates(setup, {});
    EXPECT_EQ(setup.body->kind, fem::ElementKind::tet10);
    EXPECT_EQ(tried.body->kind, fem::ElementKind::tet10_fine);
    EXPECT_EQ(tried.body->clamped, setup.body->clamped);
    for (const setup::PreparedTrial& trial : tried.trials) EXPECT_EQ(trial.model.body, tried.body);
    DiagnoseSettings none;
    none.without = {"strain_stiffening", "stress_softening", "stiffness_gradient", "soft_patch"};
    EXPECT_EQ(for_candidates(setup, none).body, setup.body);
    Diagnosis diagnosis;
    EXPECT_EQ(as_diagnosed(diagnosis, setup).body->kind, fem::ElementKind::tet10_fine);
}

/// Without such an effect the finer element differs only where strains are large, here by 0.1 % of the motion.
TEST(CandidateElement, HardlyMovesAModelWithoutSuchAnEffect) {
    const test::Folder folder("fine_same");
    const setup::Setup setup = beam_of(folder, fem::ElementKind::tet10);
    const setup::Setup fine = setup::with_fine_element(setup);
    const prediction::ParameterValues values = prediction::declared_values(setup);
    const prediction::TrialPrediction four = prediction::predict_trial(setup, 0, values),
                                      ten = prediction::predict_trial(fine, 0, values);
    ASSERT_TRUE(four.ok() && ten.ok());
    double moved = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < four.trace.positions.size(); ++k) {
        moved = std::max(moved, (ten.trace.positions[k] - four.trace.positions[k]).cwiseAbs().maxCoeff());
        largest = std::max(largest, (four.trace.positions[k] - four.trace.positions[0]).cwiseAbs().maxCoeff());
    }
    test::record("moved", moved / largest);
    EXPECT_GT(largest, 1e-3);
    EXPECT_LT(moved, 2e-3 * largest);
}

}  // namespace
}  // namespace myo::diagnosis
