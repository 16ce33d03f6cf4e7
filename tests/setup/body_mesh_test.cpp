#include "setup/body_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/box_mesh.hpp"
#include "mesh/region.hpp"
#include "mesh/test_surfaces.hpp"

namespace myo::setup {
namespace {

using testing::HasSubstr;

TEST(MeshBody, RefusesMoreHexahedraThanFitBeforeItTakesTheirMemory) {
    const mesh::SurfaceMesh box = mesh::box_surface({{0, 0, 0}, {0.1, 0.03, 0.03}});
    mesh::SurfaceMesh slanted = box;  // no box any more: filled by voxels
    slanted.vertices.row(0) += 0.2 * slanted.vertices.row(2);
    for (const mesh::SurfaceMesh& body : {box, slanted}) {
        const Result<BodyMesh> mesh = mesh_body(body, {fem::ElementKind::hex8, 1e-6}, {});
        ASSERT_FALSE(mesh);
        EXPECT_THAT(mesh.error().what, HasSubstr("an edge of 0.001 mm needs a grid of "));
        EXPECT_THAT(mesh.error().what, HasSubstr("over the limit of 2e+06: choose a longer edge"));
        EXPECT_TRUE(mesh_body(body, {fem::ElementKind::hex8, 0.01}, {}));
    }
}

/// A box of half a millimetre around the end face selects the face, whatever the edge length; a deep one holds what is
/// inside.
TEST(HeldPart, OfAThinBoxIsTheFace) {
    const Box body{{0, 0, 0}, {0.1, 0.03, 0.03}};
    const Box face{{-5e-4, -1e-3, -1e-3}, {5e-4, 0.031, 0.031}}, far{{0.0995, -1e-3, -1e-3}, {0.2, 0.031, 0.031}};
    const Box deep{{-5e-4, -1e-3, -1e-3}, {5e-3, 0.031, 0.031}};
    EXPECT_LT(held_part(face, body).highest(0), 1e-6);
    EXPECT_GT(held_part(face, body).highest(0), 0.0);
    EXPECT_GT(held_part(far, body).lowest(0), 0.1 - 1e-6);
    EXPECT_EQ(held_part(deep, body).highest, deep.highest);
    EXPECT_EQ(held_part(deep, body).lowest, deep.lowest);
    for (const double edge : {0.01, 0.005, 0.00375}) {
        const Result<BodyMesh> mesh = mesh_body(mesh::box_surface(body), {fem::ElementKind::hex8, edge},
                                                {held_part(face, body)});
        ASSERT_TRUE(mesh);
        const double along = std::round(0.1 / edge), across = std::round(0.03 / edge);
        EXPECT_EQ(static_cast<double>(mesh->mesh.cell_count()), along * across * across)
            << "no extra layer at the clamp";
    }
}

/// A clamp whose face lies within a body of tetrahedra holds what it declares; one a hair beside a face of the body is
/// told of.
TEST(MeshBody, OfTetrahedraMeetsTheClamp) {
    const mesh::SurfaceMesh bar = mesh::box_surface({{0, 0, 0}, {0.125, 0.02, 0.02}});
    const Box held{{-1, -1, -1}, {0.025, 1, 1}};
    const Result<BodyMesh> mesh = mesh_body(bar, {fem::ElementKind::tet10, {}}, {held});
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_TRUE(mesh->warnings.empty());
    double reach = 0.0;
    for (const int node : mesh::nodes_in_box(mesh->mesh, held)) reach = std::max(reach, mesh->mesh.nodes(0, node));
    EXPECT_NEAR(reach, 0.025, 1e-9);
    EXPECT_NEAR(mesh::volume_fractions(mesh->mesh, held).dot(mesh::cell_volumes(mesh->mesh)), 1e-5, 1e-12);

    const Result<BodyMesh> hair = mesh_body(test::l_shape(), {fem::ElementKind::tet10, 0.004},
                                            {{{-1, -1, -1}, {0.0099, 1, 1}}});
    ASSERT_TRUE(hair) << hair.error().text();
    ASSERT_EQ(hair->warnings.size(), 1u);
    EXPECT_THAT(hair->warnings[0], HasSubstr("do not meet the faces of the declared boxes (it would take"));
    EXPECT_LT(hair->mesh.node_count(), 2000);
}

/// The paper's meshes of the beam: 100 mm over an edge of 4.2553 mm is 23.5, over 3.0395 mm 32.9.
TEST(TruncatedVoxels, ShrinkTheBodyAwayFromItsClampAsPublished) {
    const Box body{{-0.1, 0, 0}, {0, 0.03, 0.03}};
    const Box low{{-0.1005, -1e-3, -1e-3}, {-0.0995, 0.031, 0.031}}, high{{-5e-4, -1e-3, -1e-3}, {5e-4, 0.031, 0.031}};
    struct Case {
        double edge_mm;
        int nodes;
        Eigen::Vector3d size_mm;
    };
    for (const Case& one :
         {Case{100.0 / 23.5, 1536, {97.87, 29.79, 29.79}}, Case{100.0 / 32.9, 3300, {97.26, 27.36, 27.36}}})
        for (const Box& clamp : {low, high}) {
            const Box held = held_part(clamp, body);
            const Result<BodyMesh> mesh = mesh_body(
                mesh::box_surface(body), {fem::ElementKind::hex8_full, 1e-3 * one.edge_mm, Voxels::truncated}, {held});
            ASSERT_TRUE(mesh) << mesh.error().text();
            EXPECT_EQ(mesh->mesh.node_count(), one.nodes);
            const Box shrunk = mesh::bounding_box(mesh->mesh.nodes);
            EXPECT_LT((1e3 * shrunk.size() - one.size_mm).cwiseAbs().maxCoeff(), 5e-3);
            EXPECT_EQ(shrunk.highest(0) == 0.0, clamp.highest(0) > 0.0) << "the held face stays, the other draws in";
            ASSERT_TRUE(mesh->shrunk_from);
            EXPECT_THAT(mesh->warnings.front(), HasSubstr("instead of 100 x 30 x 30"));
            EXPECT_FALSE(mesh::nodes_in_box(mesh->mesh, box_on_mesh(*mesh, held)).empty())
                << "the clamp finds its face";
            // A box around the far face still holds a face, no deeper than a cell.
            const Box far = box_on_mesh(*mesh, held_part(clamp.lowest(0) < -0.05 ? high : low, body));
            EXPECT_EQ(mesh::nodes_in_box(mesh->mesh, far).size(),
                      mesh::nodes_in_box(mesh->mesh, box_on_mesh(*mesh, held)).size());
        }
}

TEST(TruncatedVoxels, AreCubesInAnyBodyAndRefuseWhatCannotBe) {
    mesh::SurfaceMesh slanted = mesh::box_surface({{0, 0, 0}, {0.1, 0.03, 0.03}});
    slanted.vertices.row(0) += 0.2 * slanted.vertices.row(2);
    const double edge = 0.0043;
    const Result<BodyMesh> mesh = mesh_body(slanted, {fem::ElementKind::hex8_full, edge, Voxels::truncated}, {});
    ASSERT_TRUE(mesh) << mesh.error().text();
    for (Eigen::Index c = 0; c < mesh->mesh.cell_count(); ++c) {
        const Eigen::Vector3d diagonal = mesh->mesh.nodes.col(mesh->mesh.cells(6, c)) -
                                         mesh->mesh.nodes.col(mesh->mesh.cells(0, c));
        EXPECT_LT((diagonal.array() - edge).abs().maxCoeff(), 1e-12);
    }
    const mesh::SurfaceMesh box = mesh::box_surface({{0, 0, 0}, {0.1, 0.03, 0.03}});
    const Result<BodyMesh> exact = mesh_body(box, {fem::ElementKind::hex8_full, 0.01, Voxels::truncated}, {});
    ASSERT_TRUE(exact);
    EXPECT_EQ(exact->mesh.cell_count(), 90) << "an edge that divides the box loses no cube to rounding";
    const Result<BodyMesh> none = mesh_body(box, {fem::ElementKind::hex8_full, 0.04, Voxels::truncated}, {});
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().what, HasSubstr("no whole cube of 40 mm fits"));
    EXPECT_FALSE(mesh_body(box, {fem::ElementKind::hex8_full, 1e-6, Voxels::truncated}, {}));
}

}  // namespace
}  // namespace myo::setup
