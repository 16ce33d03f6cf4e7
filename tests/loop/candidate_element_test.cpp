#include <gtest/gtest.h>

#include "mesh/box_mesh.hpp"
#include "support/figures.hpp"
#include "swung_beam.hpp"

// Bodies of quadratic tetrahedra have the finer element where an effect varies within cells, declared or tried.

namespace myo {
namespace {

/// The swung beam on the element's cells, with what is added to its declaration.
Study beam_of(const test::Folder& folder, ElementKind element, const std::string& added = "") {
    test::swung_beam(folder, 0.1);
    folder.write("experiment.toml", test::swung_beam_toml() + added);
    const Result<Experiment> experiment = read_experiment(folder.path());
    EXPECT_TRUE(experiment) << experiment.error().text();
    const Box box{Eigen::Vector3d::Zero(), {0.1, 0.03, 0.03}};
    StudyMesh mesh;
    mesh.element = element;
    mesh.resolution_m = 0.03;
    mesh.mesh = cell_type(element) == CellType::hex8 ? box_hex_mesh(box, {3, 1, 1})
                                                     : tet_box_mesh(box, {3, 1, 1}, cell_type(element));
    Result<Study> study = prepare_study(*experiment, {}, {}, &mesh);
    EXPECT_TRUE(study) << study.error().text();
    return std::move(*study);
}

constexpr const char* patch = R"([[effect]]
id = "soft_patch"
relative_change = -0.3
centre_m = [0.05, 0.015, 0.015]
radius_m = 0.01
)";

TEST(CandidateElement, IsFineWhereADeclaredEffectVariesWithinCells) {
    const test::Folder folder("fine_declared");
    EXPECT_EQ(beam_of(folder, ElementKind::tet10).body->kind, ElementKind::tet10);
    const Study study = beam_of(folder, ElementKind::tet10, patch);
    EXPECT_EQ(study.body->kind, ElementKind::tet10_fine);
    EXPECT_EQ(study.mesh.element, ElementKind::tet10);   // as it was asked for
    for (const StudyTrial& trial : study.trials) EXPECT_EQ(trial.model.body, study.body);
    EXPECT_EQ(beam_of(folder, ElementKind::hex8, patch).body->kind, ElementKind::hex8);
}

TEST(CandidateElement, IsFineInADiagnosisThatMayNameSuchAnEffect) {
    const test::Folder folder("fine_tried");
    const Study study = beam_of(folder, ElementKind::tet10);
    const Study tried = for_candidates(study, {});
    EXPECT_EQ(study.body->kind, ElementKind::tet10);
    EXPECT_EQ(tried.body->kind, ElementKind::tet10_fine);
    EXPECT_EQ(tried.body->clamped, study.body->clamped);
    for (const StudyTrial& trial : tried.trials) EXPECT_EQ(trial.model.body, tried.body);
    DiagnoseSettings none;
    none.without = {"strain_stiffening", "stress_softening", "stiffness_gradient", "soft_patch"};
    EXPECT_EQ(for_candidates(study, none).body, study.body);
    Diagnosis diagnosis;
    EXPECT_EQ(as_diagnosed(diagnosis, study).body->kind, ElementKind::tet10_fine);
}

/// Without such an effect the finer element differs only where strains are large, here by 0.1 % of the motion.
TEST(CandidateElement, HardlyMovesAModelWithoutSuchAnEffect) {
    const test::Folder folder("fine_same");
    const Study study = beam_of(folder, ElementKind::tet10);
    const Study fine = with_fine_element(study);
    const StudyValues values = declared_values(study);
    const TrialPrediction four = predict_trial(study, 0, values), ten = predict_trial(fine, 0, values);
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
}  // namespace myo
