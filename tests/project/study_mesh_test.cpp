#include "project/study_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace myo {
namespace {

using testing::HasSubstr;

TEST(MeshBody, RefusesMoreHexahedraThanFitBeforeItTakesTheirMemory) {
    const SurfaceMesh box = box_surface({{0, 0, 0}, {0.1, 0.03, 0.03}});
    SurfaceMesh slanted = box;   // no box any more: filled by voxels
    slanted.vertices.row(0) += 0.2 * slanted.vertices.row(2);
    for (const SurfaceMesh& body : {box, slanted}) {
        const Result<StudyMesh> mesh = mesh_body(body, {ElementKind::hex8, 1e-6}, {});
        ASSERT_FALSE(mesh);
        EXPECT_THAT(mesh.error().what, HasSubstr("an edge of 0.001 mm needs a grid of "));
        EXPECT_THAT(mesh.error().what, HasSubstr("over the limit of 2e+06: choose a longer edge"));
        EXPECT_TRUE(mesh_body(body, {ElementKind::hex8, 0.01}, {}));
    }
}

/// A box of half a millimetre around the end face selects the face, whatever the edge length; a deep one holds what is inside.
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
        const Result<StudyMesh> mesh = mesh_body(box_surface(body), {ElementKind::hex8, edge}, {held_part(face, body)});
        ASSERT_TRUE(mesh);
        const double along = std::round(0.1 / edge), across = std::round(0.03 / edge);
        EXPECT_EQ(static_cast<double>(mesh->mesh.cell_count()), along * across * across) << "no extra layer at the clamp";
    }
}

}  // namespace
}  // namespace myo
