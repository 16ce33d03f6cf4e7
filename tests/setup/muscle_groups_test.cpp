#include "setup/muscle_groups.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "fibre/painted_mask.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/region.hpp"
#include "setup/setup.hpp"
#include "support/good_experiment.hpp"

namespace myo::setup {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;
using namespace testing_support;

const std::string box_part = "box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]\nfibre = [0.999, 0.0, 0.0]";
const Box bar{{0, 0, 0}, {0.1, 0.03, 0.03}};

/// The good experiment with another part for its first muscle.
class MuscleGroups : public testing::Test {
protected:
    experiment::Experiment experiment(const std::string& part) {
        write_files(folder, replaced(good_toml, box_part, part));
        Result<experiment::Experiment> read = experiment::read_experiment(folder.path());
        EXPECT_TRUE(read) << read.error().text();
        return read ? *read : experiment::Experiment{};
    }
    static BodyMesh on(const mesh::VolumeMesh& mesh) {
        BodyMesh result;
        result.mesh = mesh;
        return result;
    }

    Folder folder{"muscle_groups"};
};

TEST_F(MuscleGroups, MaskIsTheBoxThatWasPainted) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(bar, {10, 4, 3});
    const Box part{{0.01, 0, 0}, {0.09, 0.015, 0.03}};
    ASSERT_TRUE(fibre::write_painted_mask(
        folder.path() / "left.csv", fibre::mask_of_cells(mesh, {mesh::volume_fractions(mesh, part),
                                                                Vector3d::UnitX().replicate(1, mesh.cell_count())})));
    const Result<std::vector<fibre::FibreGroup>> boxes = muscle_groups(experiment(box_part), on(mesh)),
                                                 masks = muscle_groups(experiment("mask = \"left.csv\""), on(mesh));
    ASSERT_TRUE(boxes && masks);
    ASSERT_EQ(masks->size(), 2u);
    EXPECT_EQ((*masks)[0].name, "left");
    EXPECT_EQ((*masks)[0].stiffness_Pa, 8e4);
    ASSERT_EQ((*masks)[0].points.size(), (*boxes)[0].points.size());
    EXPECT_NEAR((*masks)[0].volume(), part.size().prod(), 1e-15);
    EXPECT_NEAR((*masks)[1].volume(), part.size().prod(), 1e-15) << "the antagonist keeps its box";
    // Another direction than painted; and the pair of antagonists is tied as before.
    const experiment::Experiment turned = experiment("mask = \"left.csv\"\nfibre = [0, 0, 1]");
    const Result<std::vector<fibre::FibreGroup>> groups = muscle_groups(turned, on(mesh));
    ASSERT_TRUE(groups);
    for (const fibre::FibrePoint& point : (*groups)[0].points) {
        Vector3d m = Vector3d::Zero();
        for (int n = 0; n < 8; ++n) m += point.shape(n) * mesh.nodes.col(mesh.cells(n, point.cell));
        ASSERT_LT((m - Vector3d::UnitZ()).norm(), 1e-12);
    }
    EXPECT_EQ(experiment::muscle_leaders(turned)[1].leader, 0u);
    EXPECT_EQ(experiment::muscle_leaders(turned)[1].factor, -0.5);
}

TEST_F(MuscleGroups, AMaskInMemoryIsThatOfItsFile) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(bar, {10, 4, 3});
    const fibre::PaintedMask mask = fibre::mask_of_cells(
        mesh, {mesh::volume_fractions(mesh, {{0.02, 0, 0}, {0.07, 0.01, 0.03}}),
               Vector3d::UnitX().replicate(1, mesh.cell_count())});
    experiment::Experiment e = experiment(box_part);
    e.muscles[0].part = experiment::MuscleMask{std::make_shared<const fibre::PaintedMask>(mask), std::nullopt};
    Result<std::vector<fibre::FibreGroup>> groups = muscle_groups(e, on(mesh));
    ASSERT_TRUE(groups);
    EXPECT_NEAR((*groups)[0].volume(), 0.05 * 0.01 * 0.03, 1e-15);
    // As paint it is what it was made from.
    const fibre::CellPaint paint = fibre::paint_of_group(mesh, (*groups)[0]);
    EXPECT_LT((paint.weights - fibre::paint_of_mask(mesh, mask).weights).norm(), 1e-9);
    for (Eigen::Index c = 0; c < paint.count(); ++c)
        EXPECT_NEAR(std::abs(paint.directions(0, c)), paint.weights(c) > 0.0 ? 1.0 : 0.0, 1e-12);
    // Nothing painted yet is a muscle without fibres.
    e.muscles[0].part = experiment::MuscleMask{std::make_shared<const fibre::PaintedMask>(), std::nullopt};
    groups = muscle_groups(e, on(mesh));
    ASSERT_TRUE(groups) << groups.error().text();
    EXPECT_TRUE((*groups)[0].points.empty());
}

TEST_F(MuscleGroups, AMusclesOwnSignalIsReadAndItsFollowersTakeTheirShare) {
    folder.write("bend.csv", "time_s,left\n0,1\n0.5,0.8\n");
    const experiment::Experiment e = experiment(box_part + "\nsignal = \"bend.csv\"");
    ASSERT_TRUE(e.muscles[0].signal);
    std::vector<fibre::Signal> activation(2, fibre::Signal::constant(1.0));
    declare_activation(e, activation);
    EXPECT_DOUBLE_EQ(activation[0].value(0.25), 0.9);
    EXPECT_DOUBLE_EQ(activation[1].value(0.25), 1.05) << "the antagonist has ratio -0.5";
    // Whatever a trial recorded for it, or did not.
    folder.write("signal.csv", "time_s,left\n0,0.5\n1,1.5\n");
    const Result<measurement::ActuationTable> recorded = experiment::read_trial_actuation(e, e.trials.front());
    ASSERT_TRUE(recorded) << recorded.error().text();
    EXPECT_EQ(recorded->values.row(0).maxCoeff(), 1.0);
    write_files(folder, replaced(good_toml, box_part, box_part + "\nsignal = \"other.csv\""));
    folder.write("other.csv", "time_s,right\n0,1\n");
    const Result<experiment::Experiment> bad = experiment::read_experiment(folder.path());
    ASSERT_FALSE(bad);
    EXPECT_THAT(bad.error().text(), HasSubstr("muscle[0].signal: other.csv has no column \"left\""));
}

TEST_F(MuscleGroups, LineHoldsItsCylinderOnEveryMesh) {
    const experiment::Experiment e = experiment(
        "line_m = [[0.01, 0.01, 0.01], [0.05, 0.01, 0.01], [0.09, 0.01, 0.02]]\nradius_m = 0.004");
    const double length = 0.04 + std::hypot(0.04, 0.01);
    for (const mesh::CellType type : {mesh::CellType::hex8, mesh::CellType::tet4, mesh::CellType::tet10}) {
        const mesh::VolumeMesh mesh = type == mesh::CellType::hex8 ? mesh::box_hex_mesh(bar, {9, 3, 3})
                                                                   : mesh::tet_box_mesh(bar, {9, 3, 3}, type);
        const Result<std::vector<fibre::FibreGroup>> groups = muscle_groups(e, on(mesh));
        ASSERT_TRUE(groups) << groups.error().text();
        EXPECT_NEAR((*groups)[0].volume() / (std::numbers::pi * 16e-6 * length), 1.0, 0.005) << to_string(type);
    }
}

/// A mesh that shrank (truncated voxels) takes the muscle along.
TEST_F(MuscleGroups, MoveWithAMeshThatShrank) {
    const mesh::VolumeMesh small = mesh::box_hex_mesh({{0, 0, 0}, {0.05, 0.015, 0.015}}, {10, 4, 3});
    BodyMesh mesh = on(small);
    mesh.shrunk_from = bar;
    const mesh::VolumeMesh whole = mesh::box_hex_mesh(bar, {10, 4, 3});
    const Box part{{0.01, 0, 0}, {0.09, 0.015, 0.03}};
    ASSERT_TRUE(fibre::write_painted_mask(
        folder.path() / "left.csv", fibre::mask_of_cells(whole, {mesh::volume_fractions(whole, part),
                                                                 Vector3d::UnitX().replicate(1, whole.cell_count())})));
    const Result<std::vector<fibre::FibreGroup>> groups = muscle_groups(experiment("mask = \"left.csv\""), mesh);
    ASSERT_TRUE(groups) << groups.error().text();
    EXPECT_NEAR((*groups)[0].volume(), part.size().prod() / 8.0, 1e-15);
}

TEST_F(MuscleGroups, ADoubtfulMaskIsToldOfUnderItsKey) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(bar, {10, 4, 3});
    const Box part{{0.01, 0, 0}, {0.09, 0.015, 0.03}};
    fibre::PaintedMask mask = fibre::mask_of_cells(
        mesh, {mesh::volume_fractions(mesh, part), Vector3d::UnitX().replicate(1, mesh.cell_count())});
    const auto warnings_of = [&] {
        EXPECT_TRUE(fibre::write_painted_mask(folder.path() / "left.csv", mask));
        std::vector<std::string> warnings;
        EXPECT_TRUE(muscle_groups(experiment("mask = \"left.csv\""), on(mesh), &warnings));
        return warnings;
    };
    EXPECT_TRUE(warnings_of().empty());
    mask.centroids_m.row(0).array() += 0.05;
    mask.cell_size_m *= 0.1;
    const std::vector<std::string> warnings = warnings_of();
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_THAT(warnings[0], HasSubstr("muscle[0].mask: cell_size_m says"));
    EXPECT_THAT(warnings[1], HasSubstr("painted elements lie where the body has none"));
}

TEST_F(MuscleGroups, WhatMeetsNoMaterialIsNamedWithItsLine) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(bar, {10, 3, 3});
    const auto error_of = [&](const std::string& part) {
        const Result<std::vector<fibre::FibreGroup>> groups = muscle_groups(experiment(part), on(mesh));
        EXPECT_FALSE(groups);
        return groups ? std::string() : groups.error().text();
    };
    const std::string toml = replaced(good_toml, box_part, "mask = \"far.csv\"");
    folder.write("far.csv", "# cell_size_m,0.01\nx_m,y_m,z_m,weight,fibre_x,fibre_y,fibre_z\n10,0,0,1,1,0,0\n");
    const std::string at = "experiment.toml:" + std::to_string(line_of(toml, "mask = "));
    EXPECT_THAT(error_of("mask = \"far.csv\""), HasSubstr(at + ": muscle[0].mask: no element of the mesh"));
    EXPECT_THAT(error_of("line_m = [[0, 0, 1], [0.1, 0, 1]]\nradius_m = 0.01"),
                HasSubstr(at + ": muscle[0].line_m: no material"));
    EXPECT_THAT(error_of("mask = \"signal.csv\""), HasSubstr("signal.csv:1: begins with '-'"));
}

}  // namespace
}  // namespace myo::setup
