#include "mesh/surface_parts.hpp"

#include <gtest/gtest.h>

#include "mesh/surface_check.hpp"
#include "mesh/test_surfaces.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/voxel_mesh.hpp"

namespace myo::mesh {
namespace {

const SurfaceMesh whole_box = box_surface({{0, 0, 0}, {0.06, 0.03, 0.03}});
const SurfaceMesh inner_box = box_surface({{0.01, 0.01, 0.01}, {0.05, 0.02, 0.02}});
constexpr double outer_m3 = 5.4e-5, inner_m3 = 4e-6;

TEST(FacingParts, InnerPartThatFacesOutwardBecomesACavityInEveryMesh) {
    const Result<FacingParts> parts = facing_parts(test::together(whole_box, inner_box));
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->notes.size(), 1u);
    for (const char* words : {"part 2, from (10, 10, 10) to (50, 20, 20) mm", "cavity of 4 ml", "delete it"})
        EXPECT_NE(parts->notes[0].find(words), std::string::npos) << parts->notes[0];
    EXPECT_NEAR(enclosed_volume(parts->surface), outer_m3 - inner_m3, 1e-15);
    VoxelOptions voxels;
    voxels.edge = 0.005;
    const auto hexahedra = voxelize(parts->surface, voxels);
    ASSERT_TRUE(hexahedra);
    EXPECT_NEAR(cell_volumes(*hexahedra).sum(), outer_m3 - inner_m3, 1e-15);
    TetOptions options;
    options.edge = 0.008;
    const auto tetrahedra = tetrahedralize(parts->surface, options);
    ASSERT_TRUE(tetrahedra) << tetrahedra.error().text();
    EXPECT_NEAR(cell_volumes(*tetrahedra).sum(), outer_m3 - inner_m3, 1e-15);
}

TEST(FacingParts, PartsThatFaceAsTheyMustStay) {
    const SurfaceMesh core = box_surface({{0.02, 0.012, 0.012}, {0.03, 0.018, 0.018}});
    const SurfaceMesh beside = box_surface({{0.07, 0, 0}, {0.08, 0.01, 0.01}});
    // Beside the body a foot that shares a part of a face plane with it.
    const SurfaceMesh foot = box_surface({{0.01, 0.01, -0.01}, {0.02, 0.02, 0}});
    for (const SurfaceMesh& surface : {whole_box, test::together(whole_box, flipped(inner_box)),
                                       test::together(test::together(whole_box, flipped(inner_box)), core),
                                       test::together(whole_box, beside), test::together(whole_box, foot)}) {
        const Result<FacingParts> parts = facing_parts(surface);
        ASSERT_TRUE(parts) << parts.error().text();
        EXPECT_TRUE(parts->notes.empty());
        EXPECT_EQ(parts->surface.triangles, surface.triangles);
    }
}

TEST(FacingParts, SolidsThatFaceInwardAreTurned) {
    const SurfaceMesh beside = box_surface({{0.07, 0, 0}, {0.08, 0.01, 0.01}});
    const SurfaceMesh core = box_surface({{0.02, 0.012, 0.012}, {0.03, 0.018, 0.018}});
    const Result<FacingParts> parts = facing_parts(test::together(whole_box, flipped(beside)));
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->notes.size(), 1u);
    EXPECT_NEAR(enclosed_volume(parts->surface), outer_m3 + 1e-6, 1e-15);
    const Result<FacingParts> nested = facing_parts(
        test::together(test::together(whole_box, inner_box), flipped(core)));
    ASSERT_TRUE(nested);
    EXPECT_EQ(nested->notes.size(), 2u);
    EXPECT_NEAR(enclosed_volume(nested->surface), outer_m3 - inner_m3 + 3.6e-7, 1e-15);
}

TEST(FacingParts, OverlapNamesBothParts) {
    const SurfaceMesh across = box_surface({{0.02, -0.01, 0.011}, {0.03, 0.04, 0.019}});
    const Result<FacingParts> parts = facing_parts(test::together(whole_box, across));
    ASSERT_FALSE(parts);
    for (const char* words : {"part 1, from (0, 0, 0) to (60, 30, 30) mm",
                              "part 2, from (20, -10, 11) to (30, 40, 19) mm", "Boolean union"})
        EXPECT_NE(parts.error().what.find(words), std::string::npos) << parts.error().what;
}

}  // namespace
}  // namespace myo::mesh
