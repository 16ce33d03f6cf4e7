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

}  // namespace
}  // namespace myo
