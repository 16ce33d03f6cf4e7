#include "fibre/cell_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "fibre/moved_fibres.hpp"
#include "fibre/polyline.hpp"
#include "mesh/box_mesh.hpp"

// Parts of cells with their volumes and moments, muscle in them, what becomes of it when nodes move, and points beside
// a line.

namespace myo::fibre::cell_parts_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// A sheared box as one hexahedron, or as tetrahedra; all cells have parallel or straight edges.
mesh::VolumeMesh sheared(mesh::CellType type) {
    const Box block{{0.1, -0.2, 0.3}, {0.13, -0.15, 0.4}};
    mesh::VolumeMesh mesh = type == mesh::CellType::hex8 ? mesh::box_hex_mesh(block, {1, 1, 1})
                                                         : mesh::tet_box_mesh(block, {1, 1, 1}, type);
    Matrix3d shear;
    shear << 1.0, 0.3, -0.2, 0.1, 0.9, 0.4, 0.0, -0.3, 1.2;
    mesh.nodes = (shear * mesh.nodes).eval();
    return mesh;
}

const std::vector<mesh::CellType> all_types{mesh::CellType::hex8, mesh::CellType::tet4, mesh::CellType::tet10};

/// Volume, centre and second moment of a body are those of its parts together (parallel axes).
TEST(CellParts, AddUpToTheirCell) {
    for (const mesh::CellType type : all_types) {
        const mesh::VolumeMesh mesh = sheared(type);
        for (int cell = 0; cell < mesh.cell_count(); ++cell) {
            const CellPart whole = whole_cell(type);
            const PartPlace place = place_of(mesh, cell, whole);
            EXPECT_NEAR(place.volume_m3, mesh::cell_volumes(mesh)[cell], 1e-12 * place.volume_m3);
            double volume = 0.0;
            Vector3d moment = Vector3d::Zero();
            Matrix3d second = Matrix3d::Zero();
            for (const CellPart& child : cut_in_eight(whole))
                for (const CellPart& part : cut_in_eight(child)) {
                    const PartPlace own = place_of(mesh, cell, part);
                    EXPECT_NEAR(own.volume_m3, place.volume_m3 / 64.0, 1e-12 * place.volume_m3);
                    const Vector3d offset = own.centre_m - place.centre_m;
                    volume += own.volume_m3;
                    moment += own.volume_m3 * offset;
                    second += own.volume_m3 * (own.second_moment_m2 + offset * offset.transpose());
                    EXPECT_LE(offset.norm() + own.radius_m, 2.0 * place.radius_m);
                }
            EXPECT_NEAR(volume, place.volume_m3, 1e-12 * volume);
            EXPECT_LT(moment.norm(), 1e-12 * volume * place.radius_m);
            EXPECT_LT((second / volume - place.second_moment_m2).norm(), 1e-12 * place.second_moment_m2.norm());
        }
    }
}

TEST(CellParts, AreNumberedToTheSecondDivision) {
    for (const mesh::CellType type : all_types) {
        std::set<int> blocks;
        for (const CellPart& child : cut_in_eight(whole_cell(type))) {
            EXPECT_EQ(child.depth, 1);
            for (const CellPart& part : cut_in_eight(child)) {
                EXPECT_EQ(part.depth, 2);
                EXPECT_EQ(part.block / 8, child.block);
                blocks.insert(part.block);
                for (const CellPart& small : cut_in_eight(part)) EXPECT_EQ(small.block, part.block) << "its ancestor's";
            }
        }
        EXPECT_EQ(blocks.size(), 64u);
        EXPECT_EQ(*blocks.begin(), 0);
        EXPECT_EQ(*blocks.rbegin(), 63);
    }
}

TEST(CellParts, WidthsOfABrickAreItsSides) {
    const mesh::VolumeMesh brick = mesh::box_hex_mesh({{0, 0, 0}, {0.01, 0.02, 0.06}}, {1, 1, 1});
    const PartPlace place = place_of(brick, 0, whole_cell(mesh::CellType::hex8));
    EXPECT_LT((place.centre_m - Vector3d(0.005, 0.01, 0.03)).norm(), 1e-16);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(place.width_m(Vector3d::Unit(axis)), brick.nodes.row(axis).maxCoeff(), 1e-15);
    EXPECT_NEAR(place.radius_m, 0.5 * std::sqrt(1e-4 + 4e-4 + 36e-4), 1e-15);
    const PartPlace eighth = place_of(brick, 0, cut_in_eight(whole_cell(mesh::CellType::hex8))[6]);
    EXPECT_NEAR(eighth.width_m(Vector3d::UnitZ()), 0.03, 1e-15);
    EXPECT_LT((eighth.centre_m - Vector3d(0.0075, 0.015, 0.045)).norm(), 1e-16) << "the corner across";
}

/// Nodes of the cell of a fibre point.
Matrix3Xd nodes_of(const mesh::VolumeMesh& mesh, const FibrePoint& point) {
    return mesh.nodes(Eigen::all, mesh.cells.col(point.cell));
}

TEST(FibrePoints, OfAWholeCellHaveItsVolumeAndTheirDirections) {
    const auto direction = [](const Vector3d& x) { return Vector3d(1.0 + 5.0 * x.x(), x.y(), -x.z()).normalized(); };
    for (const mesh::CellType type : all_types) {
        const mesh::VolumeMesh mesh = sheared(type);
        FibreGroup group;
        for (int cell = 0; cell < mesh.cell_count(); ++cell) add_whole_cell(mesh, cell, 0.25, direction, group);
        double volume = 0.0;
        ASSERT_EQ(group.points.size(), group.gradients.size());
        for (std::size_t k = 0; k < group.points.size(); ++k) {
            const Matrix3Xd X = nodes_of(mesh, group.points[k]);
            volume += group.points[k].volume;
            EXPECT_NEAR((X * group.points[k].shape).norm(), 1.0, 1e-12) << "unit at rest";
            EXPECT_LT((X * group.gradients[k] - Matrix3d::Identity()).norm(), 1e-12);
        }
        EXPECT_NEAR(volume, 0.25 * mesh::cell_volumes(mesh).sum(), 1e-12 * volume);
    }
}

TEST(FibrePoints, OfSamplesAreMergedByBlocks) {
    const auto parts = cut_in_eight(cut_in_eight(whole_cell(mesh::CellType::hex8))[3]);
    const auto halves = cut_in_eight(parts[5]);
    const std::vector<FibreSample> samples{{halves[0], 1e-9, Vector3d::UnitX()},
                                           {halves[7], 3e-9, -Vector3d::UnitX()},
                                           {parts[2], 2e-9, Vector3d(0.0, -0.6, 0.8)}};
    const mesh::VolumeMesh brick = mesh::box_hex_mesh({{0, 0, 0}, {1, 2, 3}}, {1, 1, 1});
    FibreGroup group;
    add_samples(brick, 0, samples, group);
    ASSERT_EQ(group.points.size(), 2u) << "two samples lie in one block";
    // Blocks come in their order: that of parts[2] first.
    EXPECT_DOUBLE_EQ(group.points[0].volume, 2e-9);
    EXPECT_LT((nodes_of(brick, group.points[0]) * group.points[0].shape - Vector3d(0.0, -0.6, 0.8)).norm(), 1e-14);
    EXPECT_DOUBLE_EQ(group.points[1].volume, 4e-9);
    EXPECT_LT((nodes_of(brick, group.points[1]) * group.points[1].shape - Vector3d::UnitX()).norm(), 1e-14)
        << "opposite senses are one direction";
    // A linear tetrahedron has one strain: one point for all.
    const mesh::VolumeMesh tets = sheared(mesh::CellType::tet4);
    const auto quarters = cut_in_eight(whole_cell(mesh::CellType::tet4));
    FibreGroup single;
    add_samples(tets, 2, {{quarters[0], 1e-9, Vector3d::UnitX()}, {quarters[7], 1e-9, Vector3d::UnitY()}}, single);
    ASSERT_EQ(single.points.size(), 1u);
    EXPECT_DOUBLE_EQ(single.points[0].volume, 2e-9);
    EXPECT_EQ(single.points[0].cell, 2);
    FibreGroup none;
    add_samples(brick, 0, {}, none);
    EXPECT_TRUE(none.points.empty());
}

TEST(MeanLine, PointsAlongItsLargestComponent) {
    const Vector3d a = Vector3d(0.1, -0.9, 0.3).normalized(), b = Vector3d(-0.2, 0.9, -0.3).normalized();
    const Matrix3d sum = a * a.transpose() + b * b.transpose();
    const Vector3d mean = mean_line(sum);
    EXPECT_NEAR(mean.norm(), 1.0, 1e-14);
    EXPECT_GT(mean.y(), 0.9) << "the sign of the largest component";
    EXPECT_LT((mean - (b - a).normalized()).norm(), 1e-13) << "between two lines of one weight";
    EXPECT_LT((mean_line(1e-12 * sum) - mean).norm(), 1e-12);
}

/// A linear change of the rest shape turns directions with the material and scales volumes.
TEST(MovedFibres, GoWithTheRestShape) {
    Matrix3d A;
    A << 1.1, 0.2, 0.0, -0.1, 0.9, 0.3, 0.05, 0.0, 1.3;
    for (const mesh::CellType type : all_types) {
        const mesh::VolumeMesh before = sheared(type);
        mesh::VolumeMesh after = before;
        after.nodes = (A * before.nodes).eval();
        const Vector3d direction = Vector3d(1.0, -2.0, 0.5).normalized();
        FibreGroup group;
        for (int cell = 0; cell < before.cell_count(); ++cell)
            add_whole_cell(
                before, cell, 1.0, [&](const Vector3d&) { return direction; }, group);
        const FibreGroup moved = moved_fibres(before, after, group);
        for (std::size_t k = 0; k < group.points.size(); ++k) {
            const Matrix3Xd X = nodes_of(after, moved.points[k]);
            EXPECT_LT((X * moved.points[k].shape - (A * direction).normalized()).norm(), 1e-11);
            EXPECT_LT((X * moved.gradients[k] - Matrix3d::Identity()).norm(), 1e-11);
            EXPECT_NEAR(moved.points[k].volume, A.determinant() * group.points[k].volume, 1e-16);
        }
        const FibreGroup same = moved_fibres(before, before, group);
        for (std::size_t k = 0; k < group.points.size(); ++k) EXPECT_EQ(same.points[k].shape, group.points[k].shape);
    }
}

/// Along x for 2 m, then along y for 1 m.
const Polyline bent_line{(Matrix3Xd(3, 3) << 0, 2, 2, 0, 0, 1, 0, 0, 0).finished()};

struct Beside {
    Vector3d x;
    double distance, inward;
    Vector3d tangent, away;
};

TEST(BesideLine, KnowsSegmentsCornersAndEnds) {
    EXPECT_DOUBLE_EQ(bent_line.length_m(), 3.0);
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ(), none = Vector3d::Zero();
    const double endless = std::numeric_limits<double>::infinity(), root = std::sqrt(0.5);
    for (const Beside& at : std::vector<Beside>{
             {{0.5, 0, 0.3}, 0.3, 0.5, x, z},       // beside the first segment
             {{1.0, 0, 0}, 0.0, 1.0, x, none},      // on it
             {{2.2, 0.75, 0}, 0.2, 0.25, y, x},     // beside the last
             {{-0.5, -0.1, 0}, 0.1, -0.5, x, -y},   // before the beginning: from the line drawn on
             {{2.0, 1.5, -0.2}, 0.2, -0.5, y, -z},  // behind the end
             {{2.3, -0.4, 0}, 0.5, 2.3, root * (x + y), 0.6 * x - 0.8 * y},  // outside the corner
         }) {
        const BesideLine beside = beside_line(bent_line, at.x);
        EXPECT_NEAR(beside.distance_m, at.distance, 1e-15) << at.x.transpose();
        EXPECT_LT((beside.tangent - at.tangent).norm(), 1e-15) << at.x.transpose();
        EXPECT_NEAR(beside.inward_m, at.inward, 1e-15) << at.x.transpose();
        EXPECT_LT((beside.away - at.away).norm(), 1e-15) << at.x.transpose();
        EXPECT_NEAR(depth_in_tube(beside, 0.25), std::min(0.25 - at.distance, beside.inward_m), 1e-15);
    }
    Polyline three{(Matrix3Xd(3, 4) << 0, 2, 2, 3, 0, 0, 1, 1, 0, 0, 0, 0).finished()};
    EXPECT_EQ(beside_line(three, {2.1, 0.5, 0}).inward_m, endless) << "no end is near a segment in the middle";
    three.points_m.col(2) << 1, 0, 0;  // back on itself
    three.points_m.col(3) << 1, 1, 0;
    EXPECT_EQ(beside_line(three, {2.5, 0, 0}).tangent, x) << "a reversal has no bisector";
}

}  // namespace
}  // namespace myo::fibre::cell_parts_test
