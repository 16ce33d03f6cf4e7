#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "mesh/quality.hpp"
#include "mesh/region.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_patch.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"

// Reports on meshes and surfaces: numbers, sentences, and the thresholds from which these are said.

namespace myo::mesh::mesh_messages_test {
namespace {

using Messages = std::vector<std::string>;

const Box cube{{0, 0, 0}, {0.01, 0.01, 0.01}};

/// The cells of a block of 2 x 2 x 2 with these numbers.
VolumeMesh cells_of_block(const std::vector<int>& cells) {
    VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {0.02, 0.02, 0.02}}, {2, 2, 2});
    mesh.cells = mesh.cells(Eigen::all, cells).eval();
    return mesh;
}

TEST(QualityMessages, NamePiecesAndWeakJoints) {
    EXPECT_EQ(mesh_quality(VolumeMesh{}).messages, Messages{"the mesh has no cells"});
    EXPECT_TRUE(mesh_quality(cells_of_block({0, 1, 2})).messages.empty());
    // Cells 0 and 7 meet in the node in the middle, 0 and 3 in an edge, 0 and 1 in a face.
    EXPECT_EQ(
        mesh_quality(cells_of_block({0, 7})).messages,
        (Messages{"the mesh falls apart into 2 pieces", "cells hang together by an edge or a corner only at 1 node"}));
    EXPECT_EQ(
        mesh_quality(cells_of_block({0, 3})).messages,
        (Messages{"the mesh falls apart into 2 pieces", "cells hang together by an edge or a corner only at 2 nodes"}));
    // A chain of faces from 0 to 7 does not make their common corner stronger than that of the chain.
    EXPECT_TRUE(mesh_quality(cells_of_block({0, 1, 3, 7})).messages.empty());
    const QualityReport apart = mesh_quality(cells_of_block({0, 7}));
    EXPECT_EQ(apart.components, 2);
    EXPECT_EQ(apart.weak_edges, 0);
    EXPECT_EQ(apart.weak_nodes, 1);
}

TEST(QualityMessages, NameTheCellThatIsTurned) {
    VolumeMesh mesh = cells_of_block({0, 1, 2, 3});
    mesh.cells.col(2) = mesh.cells.col(2)({4, 5, 6, 7, 0, 1, 2, 3}).eval();
    const QualityReport report = mesh_quality(mesh);
    EXPECT_NEAR(report.least, -1.0, 1e-14);
    EXPECT_EQ(report.worst_cell, 2);
    EXPECT_NEAR(report.mean, 0.5, 1e-14) << "three cubes and their opposite";
    EXPECT_EQ(report.histogram[0], 1);
    EXPECT_EQ(report.histogram[9], 3);
    EXPECT_EQ(report.messages, Messages{"cell 2 is turned inside out"});
}

/// One per cent of the surface's volume is allowed, in either direction.
TEST(QualityMessages, CompareTheVolumeWithThatOfTheSurface) {
    const VolumeMesh mesh = box_hex_mesh(cube, {1, 1, 1});
    for (const double error : {-0.02, -0.0101, -0.0099, 0.0, 0.0099, 0.0101, 0.02}) {
        SurfaceMesh surface = box_surface(cube);
        surface.vertices.row(0) /= 1.0 + error;
        const QualityReport report = mesh_quality(mesh, &surface);
        ASSERT_TRUE(report.volume_error);
        EXPECT_NEAR(*report.volume_error, error, 1e-13);
        EXPECT_EQ(report.messages.size(), std::abs(error) > 0.01 ? 1u : 0u) << error;
        SurfaceMesh inward = flipped(surface);
        EXPECT_NEAR(*mesh_quality(mesh, &inward).volume_error, error, 1e-13) << "whichever way it faces";
        if (error == 0.02)
            EXPECT_EQ(report.messages[0],
                      "the mesh's volume differs from the surface's by 2 %, more than 1 %: choose shorter edges or "
                      "tetrahedra");
    }
    EXPECT_FALSE(mesh_quality(mesh).volume_error);
}

/// Edges of a 2 x 1 x 1 grid: per axis their number times their length; each counts once, however many cells share it.
TEST(MeanEdge, CountsEachEdgeOnce) {
    const Box box{{0, 0, 0}, {2.0, 3.0, 5.0}};
    EXPECT_NEAR(mean_edge_length(box_hex_mesh(box, {2, 1, 1})), (8 * 1.0 + 6 * 3.0 + 6 * 5.0) / 20.0, 1e-14);
    // Kuhn's six tetrahedra of one box: 12 edges, 6 diagonals of faces and the main one.
    const double mean = (4.0 * (2.0 + 3.0 + 5.0) + 2.0 * (std::sqrt(13.0) + std::sqrt(29.0) + std::sqrt(34.0)) +
                         std::sqrt(38.0)) /
                        19.0;
    EXPECT_NEAR(mean_edge_length(tet_box_mesh(box, {1, 1, 1})), mean, 1e-14);
    EXPECT_NEAR(mean_edge_length(tet_box_mesh(box, {1, 1, 1}, CellType::tet10)), mean, 1e-14) << "between corners";
    EXPECT_EQ(mean_edge_length(VolumeMesh{}), 0.0);
}

/// A tetrahedron of equal legs at a right angle: V = a^3 / 6, squares 9 a^2.
TEST(CellShapes, HaveTheirClosedForms) {
    VolumeMesh corner{CellType::tet4, Eigen::Matrix3Xd(3, 4), Eigen::MatrixXi(4, 1)};
    corner.nodes << 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2;
    corner.cells << 0, 1, 2, 3;
    EXPECT_NEAR(cell_shapes(corner)[0], 12.0 * std::pow(0.5, 2.0 / 3.0) / 9.0, 1e-14);
    const QualityReport report = mesh_quality(corner);
    EXPECT_NEAR(report.largest_dihedral_deg, 90.0, 1e-12);
    EXPECT_NEAR(report.min_dihedral_deg, std::acos(1.0 / std::sqrt(3.0)) * 180.0 / std::numbers::pi, 1e-12);
    EXPECT_EQ(report.measure, "mean ratio");
    corner.nodes.col(3).setZero();
    EXPECT_EQ(cell_shapes(corner)[0], 0.0) << "flat";
    corner.nodes.setConstant(0.3);
    EXPECT_EQ(cell_shapes(corner)[0], 0.0) << "a point";
    VolumeMesh brick = box_hex_mesh({{0, 0, 0}, {1, 2, 3}}, {1, 1, 1});
    EXPECT_NEAR(cell_shapes(brick)[0], 1.0, 1e-14) << "unequal sides are no fault of shape";
    brick.nodes.row(2).setZero();
    EXPECT_EQ(cell_shapes(brick)[0], 0.0);
}

TEST(Estimates, AreNothingWithoutAnEdgeAndExactForBoxesOnly) {
    const SurfaceMesh box = box_surface({{0, 0, 0}, {0.1, 0.03, 0.03}});
    for (const double edge : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(estimate_counts(box, CellType::hex8, edge).cells, 0.0) << edge;
    EXPECT_EQ(estimate_counts(SurfaceMesh{}, CellType::tet4, 0.01).nodes, 0.0);
    EXPECT_FALSE(estimate_counts(box, CellType::tet4, 0.004).exact);
    EXPECT_FALSE(estimate_counts(test::l_shape(), CellType::hex8, 0.004).exact);
    // Half the edge gives eight times as many tetrahedra; most of tet10's nodes stand on edges.
    const CountEstimate coarse = estimate_counts(box, CellType::tet10, 1e-3),
                        fine = estimate_counts(box, CellType::tet10, 5e-4);
    EXPECT_NEAR(fine.cells / coarse.cells, 8.0, 1e-9);
    EXPECT_EQ(fine.dofs, 3.0 * fine.nodes);
    EXPECT_GT(estimate_counts(box, CellType::tet10, 1e-3).nodes,
              5.0 * estimate_counts(box, CellType::tet4, 1e-3).nodes);
    EXPECT_NEAR(estimate_counts(flipped(box), CellType::tet4, 1e-3).cells,
                estimate_counts(box, CellType::tet4, 1e-3).cells, 1e-6);
}

TEST(SurfaceMessages, SayHowManyFaultsThereAre) {
    SurfaceMesh open = box_surface(cube);
    open.triangles = open.triangles.leftCols(11).eval();
    EXPECT_EQ(check_surface(open).messages, Messages{"the surface is not closed: 3 open edges"});
    EXPECT_EQ(check_surface(flipped(box_surface(cube))).messages, Messages{"the surface is oriented inward"});
    SurfaceMesh turned = box_surface(cube);
    std::swap(turned.triangles(0, 4), turned.triangles(1, 4));
    EXPECT_EQ(check_surface(turned).messages, Messages{"neighbouring triangles turn opposite ways at 3 edges"});
    const SurfaceMesh corner = weld(
        test::together(box_surface(cube), box_surface({{0.01, 0.01, 0.01}, {0.02, 0.02, 0.02}})));
    EXPECT_EQ(check_surface(corner).messages, (Messages{"1 vertex joins parts that share no edge",
                                                        "the surface has 2 parts, as that of a body with a cavity"}));
    EXPECT_EQ(surface_topology(corner).pinched_vertices, 1);
    const SurfaceMesh edge = weld(
        test::together(box_surface(cube), box_surface({{0.01, 0.01, 0}, {0.02, 0.02, 0.01}})));
    EXPECT_EQ(check_surface(edge).messages[0], "1 edge is shared by more than two triangles");
    EXPECT_EQ(check_surface(SurfaceMesh{}).messages, Messages{"the surface has no triangles"});
}

TEST(SurfaceMessages, SizesArePlausibleFromAMillimetreToTenMetres) {
    const double above = std::nextafter(10.0, 11.0), below = std::nextafter(1e-3, 0.0);
    EXPECT_TRUE(check_plausible_size({10.0, 0.1, 0.1}));
    EXPECT_TRUE(check_plausible_size({0.0, 1e-3, 0.0}));
    EXPECT_FALSE(check_plausible_size({0.1, 0.1, above}));
    EXPECT_FALSE(check_plausible_size({below, 0.0, below}));
    EXPECT_FALSE(check_plausible_size(Eigen::Vector3d::Zero()));
    EXPECT_EQ(check_plausible_size({100.0, 30.0, 30.0}).error().what,
              "the body is 100 m long, over 10 m: the unit is almost certainly wrong");
    EXPECT_EQ(check_plausible_size({1e-4, 3e-5, 3e-5}).error().what,
              "the body is 0.1 mm long, under 1 mm: the unit is almost certainly wrong");
}

/// A millionth of the diagonal; far from the origin what single precision can tell apart.
TEST(Weld, ToleranceFollowsSizeAndPlace) {
    EXPECT_EQ(weld_tolerance(SurfaceMesh{}), 0.0);
    EXPECT_NEAR(weld_tolerance(box_surface({{0, 0, 0}, {0.2, 0.3, 0.6}})), 0.7e-6, 1e-18);
    EXPECT_NEAR(weld_tolerance(box_surface({{-100.0, 0, 0}, {-99.8, 0.3, 0.6}})), 2.4e-5, 1e-17);
    SurfaceMesh soup = test::unwelded(box_surface(cube));
    soup.vertices.col(0).x() += 1e-6;
    EXPECT_EQ(weld(soup, 1.01e-6).vertices.cols(), 8);
    EXPECT_EQ(weld(soup, 0.99e-6).vertices.cols(), 9);
    EXPECT_EQ(weld(SurfaceMesh{}).vertices.cols(), 0);
}

TEST(Region, ToleranceFollowsTheLongestExtent) {
    EXPECT_EQ(region_tolerance(VolumeMesh{}), 0.0);
    EXPECT_NEAR(region_tolerance(box_hex_mesh({{-1, 5, 5}, {1, 5.5, 6}}, {1, 1, 1})), 2e-9, 1e-22);
    const VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {2, 1, 1}}, {2, 1, 1});
    EXPECT_EQ(nodes_in_box(mesh, {{1 + 1e-9, -1, -1}, {3, 2, 2}}), (std::vector<int>{1, 2, 4, 5, 7, 8, 10, 11}));
    EXPECT_EQ(nodes_in_box(mesh, {{1 + 1e-9, -1, -1}, {3, 2, 2}}, 0.0), (std::vector<int>{2, 5, 8, 11}));
}

/// Two boxes apart: each triangle knows its box, the nearest one is that of the nearer box.
TEST(SurfacePatch, KnowsTheClosedPart) {
    const SurfacePatches patches(test::together(box_surface(cube), box_surface({{0.03, 0, 0}, {0.04, 0.01, 0.01}})));
    for (int t = 0; t < 24; ++t) EXPECT_EQ(patches.part(t), t < 12 ? 0 : 1);
    EXPECT_EQ(patches.part(patches.nearest({0.019, 0.005, 0.005}).triangle), 0);
    EXPECT_EQ(patches.part(patches.nearest({0.021, 0.005, 0.005}).triangle), 1);
    EXPECT_EQ(patches.around(patches.nearest({0.035, 0.005, 0.5}).triangle).size(), 2u) << "its own upper face";
}

}  // namespace
}  // namespace myo::mesh::mesh_messages_test
