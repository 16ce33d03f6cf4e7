#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "mesh/box_mesh.hpp"
#include "prediction/parameter_tangent.hpp"
#include "prediction/prediction.hpp"
#include "support/chambered_beam.hpp"

// Bodies that are declared by a volume mesh, whose cells are used as they are.

namespace myo::prediction {
namespace {

using testing::HasSubstr;

/// Gmsh file of the swung beam; cells beyond the middle have the physical number 2, the others 1.
std::string beam_cells(mesh::CellType type) {
    const Box box{Eigen::Vector3d::Zero(), {0.1, 0.03, 0.03}};
    const mesh::VolumeMesh mesh = type == mesh::CellType::hex8 ? mesh::box_hex_mesh(box, {6, 2, 2})
                                                               : mesh::tet_box_mesh(box, {6, 2, 2}, type);
    std::ostringstream text;
    text.precision(12);
    text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.node_count() << "\n";
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) text << i + 1 << " " << mesh.nodes.col(i).transpose() << "\n";
    text << "$EndNodes\n$Elements\n" << mesh.cell_count() << "\n";
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const double middle = mesh.nodes(Eigen::all, mesh.cells.col(c)).row(0).mean();
        text << c + 1 << (type == mesh::CellType::hex8 ? " 5 2 " : " 4 2 ") << (middle > 0.05 ? 2 : 1) << " 1";
        for (const int node : mesh.cells.col(c)) text << " " << node + 1;
        text << "\n";
    }
    text << "$EndElements\n";
    return text.str();
}

/// Writes the experiment of the swung beam with these cells, and with a part of region 2 if wished.
void write_beam(const test::Folder& folder, mesh::CellType type, bool with_part) {
    test::swung_beam(folder, 0.1);  // writes the traces
    folder.write("body.msh", beam_cells(type));
    const std::string part =
        "\n[[part]]\nname = \"end\"\nregion = 2\nyoungs_modulus_Pa = 8e5\ndensity_kg_m3 = 2000\n"
        "calibrate = [\"youngs_modulus\", \"damping\"]\n";
    folder.write("experiment.toml",
                 testing_support::replaced(test::swung_beam_toml(), "kind = \"box\"\nsize_m = [0.1, 0.03, 0.03]",
                                           "kind = \"volume\"\nfile = \"body.msh\"\nunit = \"m\"") +
                     (with_part ? part : ""));
}

TEST(VolumeGeometry, IsUsedAsItIs) {
    const test::Folder folder("volume_cells");
    for (const mesh::CellType type : {mesh::CellType::hex8, mesh::CellType::tet4}) {
        write_beam(folder, type, false);
        const setup::Setup setup = test::setup_of_folder(folder, {});
        EXPECT_EQ(setup.body->cell_count(), type == mesh::CellType::hex8 ? 24 : 6 * 24);
        // Linear tetrahedra lock; they get nodes at the middles of their edges.
        EXPECT_EQ(setup.body->mesh.type, type == mesh::CellType::hex8 ? mesh::CellType::hex8 : mesh::CellType::tet10);
        EXPECT_NEAR(setup.body->volume_m3, 0.1 * 0.03 * 0.03, 1e-12);
        const TrialPrediction swing = predict_trial(setup, 0, declared_values(setup));
        ASSERT_TRUE(swing.ok()) << swing.message;
        EXPECT_LT(swing.positions_m[0](2, 9), 0.03 - 0.001) << "it falls";
    }
}

TEST(VolumeGeometry, TakesNoOtherEdgeLengthOrElement) {
    const test::Folder folder("volume_request");
    write_beam(folder, mesh::CellType::hex8, false);
    const Result<experiment::Experiment> experiment = experiment::read_experiment(folder.path());
    ASSERT_TRUE(experiment) << experiment.error().text();
    setup::SetupSettings settings;
    settings.mesh.resolution_m = 0.01;
    Result<setup::Setup> setup = setup::prepare_setup(*experiment, settings);
    ASSERT_FALSE(setup);
    EXPECT_THAT(setup.error().text(), HasSubstr("leave the edge length (--resolution) out"));
    settings.mesh = {fem::ElementKind::tet10, {}};
    setup = setup::prepare_setup(*experiment, settings);
    ASSERT_FALSE(setup);
    EXPECT_THAT(setup.error().text(), HasSubstr("holds hex8 cells"));
}

/// Modulus and damping of a part have exact derivatives, and those of the body leave the part alone.
TEST(VolumeGeometry, HasPartsWithDerivativesOfTheirOwn) {
    const test::Folder folder("volume_parts");
    write_beam(folder, mesh::CellType::hex8, true);
    setup::Setup setup = test::setup_of_folder(folder, {});
    setup.trials[0].options.solver.tolerance = setup.trials[0].options.solver.tangent_tolerance = 1e-11;
    const ParameterValues values = declared_values(setup);
    EXPECT_EQ(values.part_modulus_Pa, std::vector<double>{8e5});
    std::vector<ModelParameter> parameters = free_parameters(setup);
    ASSERT_EQ(parameters.size(), 3u);
    EXPECT_EQ(parameters[1].parameter.name, "end.youngs_modulus_Pa");
    EXPECT_EQ(parameters[2].parameter.name, "end.damping_s");
    const TrialPrediction here = predict_trial(setup, 0, values, parameters);
    ASSERT_TRUE(here.ok()) << here.message;
    for (std::size_t p = 0; p < parameters.size(); ++p) {
        const double value = value_of(parameters[p], values), step = 1e-3 * value;
        const auto at = [&](double changed) {
            ParameterValues there = values;
            set_value(parameters[p], changed, there);
            const TrialPrediction run = predict_trial(setup, 0, there);
            EXPECT_TRUE(run.ok()) << run.message;
            return run.positions_m[0];
        };
        // Fourth order, so that the difference itself is exact to about 1e-8.
        const Eigen::Matrix3Xd difference = (8.0 * (at(value + step) - at(value - step)) -
                                             (at(value + 2.0 * step) - at(value - 2.0 * step))) /
                                            (12.0 * step);
        EXPECT_GT(difference.norm(), 0.0) << parameters[p].parameter.name;
        EXPECT_LT((here.tangents[p][0] - difference).norm(), 1e-6 * difference.norm()) << parameters[p].parameter.name;
    }
}

}  // namespace
}  // namespace myo::prediction
