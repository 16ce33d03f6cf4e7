#include "fibre/painted_mask.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fibre/pulled.hpp"
#include "mesh/region.hpp"
#include "support/figures.hpp"
#include "support/folder.hpp"

namespace myo::fibre {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::all_cell_types;
using test::mesh_of;

const Box painted_box{{0.2, 0.0, 0.3}, {0.8, 0.4, 0.6}};

/// The cells within the box, along x.
PaintedMask boxed_mask(const mesh::VolumeMesh& mesh) {
    return mask_of_cells(
        mesh, {mesh::volume_fractions(mesh, painted_box), Vector3d::UnitX().replicate(1, mesh.cell_count())});
}

TEST(PaintedMask, OnItsOwnMeshIsWhatWasPainted) {
    for (const mesh::CellType type : all_cell_types) {
        const mesh::VolumeMesh mesh = type == mesh::CellType::hex8 ? mesh_of(type, {10, 8, 6})
                                                                   : test::distorted_mesh(type, {4, 3, 3}, 0.1);
        VectorXd weights = mesh::volume_fractions(mesh, painted_box);
        Matrix3Xd directions = test::rough_field(mesh.cell_count(), 0.3).colwise().normalized();
        const PaintedMask mask = mask_of_cells(mesh, {weights, directions});
        const FibreGroup group = fibres_of_mask(mesh, mask, 2.0, "painted");
        EXPECT_NEAR(group.volume(), weights.dot(mesh::cell_volumes(mesh)), 1e-13) << to_string(type);
        for (const FibrePoint& point : group.points) {
            Vector3d m = Vector3d::Zero();
            for (int n = 0; n < point.shape.size(); ++n)
                m += point.shape(n) * mesh.nodes.col(mesh.cells(n, point.cell));
            ASSERT_LT((m - directions.col(point.cell)).norm(), 1e-9);
        }
    }
}

TEST(PaintedMask, PullsLikeTheBoxOfTheSameCells) {
    const mesh::VolumeMesh mesh = mesh_of(mesh::CellType::hex8, {10, 8, 6});
    const FibreGroup mask = fibres_of_mask(mesh, boxed_mask(mesh), 2.0, "mask"),
                     box = fibres_in_box(mesh, painted_box, Vector3d::UnitX(), 2.0, "box");
    EXPECT_LT(test::relative_difference(test::fibre_forces(mesh, mask, test::bent(mesh), 0.8),
                                        test::fibre_forces(mesh, box, test::bent(mesh), 0.8)),
              1e-12);
}

/// Painted on one mesh, used on another: volume, place and pull stay.
TEST(PaintedMask, SurvivesRemeshing) {
    double worst = 0.0, worst_work = 0.0;
    for (const mesh::CellType from : {mesh::CellType::hex8, mesh::CellType::tet4}) {
        const mesh::VolumeMesh painted = from == mesh::CellType::hex8 ? mesh_of(from, {10, 8, 6})
                                                                      : mesh_of(from, {5, 4, 4});
        const PaintedMask mask = boxed_mask(painted);
        const FibreGroup original = fibres_of_mask(painted, mask, 2.0, "painted");
        const double expected = original.volume();
        const Eigen::Vector4d expected_work = test::work(
            painted, test::fibre_forces(painted, original, test::bent(painted), 0.8));
        for (const mesh::CellType to : all_cell_types)
            for (const Eigen::Vector3i& cells :
                 {Eigen::Vector3i(3, 3, 2), Eigen::Vector3i(7, 5, 5), Eigen::Vector3i(11, 9, 7)}) {
                const mesh::VolumeMesh mesh = mesh_of(to, cells);
                const FibreGroup group = fibres_of_mask(mesh, mask, 2.0, "again");
                const double error = group.volume() / expected - 1.0;
                EXPECT_LT(std::abs(error), 0.04) << to_string(from) << " " << to_string(to) << " " << cells.transpose();
                worst = std::max(worst, std::abs(error));
                const Eigen::Vector4d work = test::work(mesh, test::fibre_forces(mesh, group, test::bent(mesh), 0.8));
                EXPECT_LT(test::relative_difference(work, expected_work), 0.06)
                    << to_string(from) << " " << to_string(to) << " " << cells.transpose();
                worst_work = std::max(worst_work, test::relative_difference(work, expected_work));
            }
    }
    test::record("worst_volume_error", worst);
    test::record("worst_work_error", worst_work);
}

/// The unpainted neighbours say where the paint ends, however fine the next mesh is: none beyond half a cell of the
/// box.
TEST(PaintedMask, DoesNotSpread) {
    const PaintedMask mask = boxed_mask(mesh_of(mesh::CellType::hex8, {10, 8, 6}));
    const mesh::VolumeMesh fine = mesh_of(mesh::CellType::hex8, {20, 16, 12});
    const FibreGroup group = fibres_of_mask(fine, mask, 2.0, "fine"),
                     box = fibres_in_box(fine, painted_box, Vector3d::UnitX(), 2.0, "box");
    EXPECT_NEAR(group.volume(), painted_box.size().prod(), 1e-12);
    EXPECT_LT(test::relative_difference(test::fibre_forces(fine, group, test::bent(fine), 0.8),
                                        test::fibre_forces(fine, box, test::bent(fine), 0.8)),
              1e-12);
}

/// Strokes painted to and fro are one field of lines: no direction cancels another.
TEST(PaintedMask, AveragesDirectionsAsLines) {
    const mesh::VolumeMesh fine = mesh_of(mesh::CellType::hex8, {10, 8, 6});
    Matrix3Xd directions = Vector3d(1, 1, 0).normalized().replicate(1, fine.cell_count());
    for (Eigen::Index c = 0; c < directions.cols(); c += 2) directions.col(c) *= -1.0;
    const PaintedMask mask = mask_of_cells(fine, {VectorXd::Ones(fine.cell_count()), directions});
    for (const mesh::CellType type : all_cell_types) {
        const mesh::VolumeMesh coarse = mesh_of(type, {3, 2, 2});
        const FibreGroup group = fibres_of_mask(coarse, mask, 2.0, "lines");
        EXPECT_NEAR(group.volume(), test::unit_box().size().prod(), 1e-12);
        const FibreGroup expected = fibres_in_box(coarse, test::unit_box(), Vector3d(1, 1, 0).normalized(), 2.0, "box");
        const Matrix3Xd x = test::mapped(coarse, Vector3d(1.2, 0.9, 1.0).asDiagonal());
        EXPECT_LT(test::relative_difference(test::fibre_forces(coarse, group, x, 0.8),
                                            test::fibre_forces(coarse, expected, x, 0.8)),
                  1e-9)
            << to_string(type);
    }
}

TEST(PaintedMask, FileKeepsEveryDigit) {
    const test::Folder folder("painted_mask");
    const mesh::VolumeMesh mesh = test::distorted_mesh(mesh::CellType::tet4, {3, 3, 3}, 0.2);
    const VectorXd weights = mesh::volume_fractions(mesh, painted_box);
    const PaintedMask mask = mask_of_cells(mesh,
                                           {weights, test::rough_field(mesh.cell_count(), 0.1).colwise().normalized()});
    ASSERT_TRUE(write_painted_mask(folder.path() / "deep" / "muscle.csv", mask));
    const Result<PaintedMask> read = read_painted_mask(folder.path() / "deep" / "muscle.csv");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->cell_size_m, mask.cell_size_m);
    EXPECT_EQ(read->centroids_m, mask.centroids_m);
    EXPECT_EQ(read->weights, mask.weights);
    EXPECT_LT((read->directions - mask.directions).norm(), 1e-14 * mask.directions.norm());
    EXPECT_NEAR(fibres_of_mask(mesh, *read, 1.0, "read").volume(), weights.dot(mesh::cell_volumes(mesh)), 1e-13);
}

TEST(PaintedMask, BadFilesAreNamedByLine) {
    const test::Folder folder("painted_mask_bad");
    const std::string good =
        "# words\n# cell_size_m,0.01\nx_m,y_m,z_m,weight,fibre_x,fibre_y,fibre_z\n0,0,0,1,1,0,0\n0.01,0,0,0,0,0,0\n";
    const auto error = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        folder.write("mask.csv", text);
        const Result<PaintedMask> read = read_painted_mask(folder.path() / "mask.csv");
        EXPECT_FALSE(read) << text;
        return read ? std::string() : read.error().text();
    };
    folder.write("mask.csv", good);
    ASSERT_TRUE(read_painted_mask(folder.path() / "mask.csv"));
    EXPECT_EQ(read_painted_mask(folder.path() / "mask.csv")->count(), 2);
    using ::testing::HasSubstr;
    EXPECT_THAT(error("m,0.01", "m,-1"), HasSubstr("mask.csv:2: the cell size is '-1'"));
    EXPECT_THAT(error("# cell_size_m,0.01\n", ""), HasSubstr("mask.csv: does not say the cell size"));
    EXPECT_THAT(error("weight,", ""), HasSubstr("mask.csv:3: begins with"));
    EXPECT_THAT(error("0,0,0,1,1,0,0", "0,0,0,1,1,0"), HasSubstr("mask.csv:4: has 6 fields, expected 7"));
    EXPECT_THAT(error("0,0,0,1,1,0,0", "0,0,zero,1,1,0,0"), HasSubstr("mask.csv:4: field 3 is 'zero'"));
    EXPECT_THAT(error("0,0,0,1,1,0,0", "0,0,nan,1,1,0,0"), HasSubstr("mask.csv:4: field 3"));
    EXPECT_THAT(error("0,0,0,1,1,0,0", "0,0,0,1.5,1,0,0"), HasSubstr("mask.csv:4: the weight is 1.5"));
    EXPECT_THAT(error("0,0,0,1,1,0,0", "0,0,0,1,1,1,0"),
                HasSubstr("mask.csv:4: the fibre must be a unit vector, not one of length 1.414"));
    EXPECT_THAT(error("0,0,0,1,1,0,0", "0,0,0,0,1,0,0"), HasSubstr("no element"));
    EXPECT_THAT(read_painted_mask(folder.path() / "none.csv").error().text(), HasSubstr("none.csv"));
    folder.write("mask.csv", "");
    EXPECT_THAT(read_painted_mask(folder.path() / "mask.csv").error().text(), HasSubstr("is empty"));
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        std::string text = good;
        for (int k = 0; k < 3; ++k) text[random() % text.size()] = static_cast<char>(random() % 256);
        folder.write("mask.csv", text);
        const Result<PaintedMask> read = read_painted_mask(folder.path() / "mask.csv");
        EXPECT_TRUE(!read || (read->centroids_m.allFinite() && read->weights.allFinite()));
    }
}

}  // namespace
}  // namespace myo::fibre
