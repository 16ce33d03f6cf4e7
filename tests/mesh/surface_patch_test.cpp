#include "mesh/surface_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace myo::mesh {
namespace {

/// A tube of n sides along z, radius 1, from z = 0 to 2, closed by fans.
SurfaceMesh prism(int sides) {
    SurfaceMesh surface{Eigen::Matrix3Xd(3, 2 * sides + 2), Eigen::Matrix3Xi(3, 4 * sides)};
    surface.vertices.col(2 * sides) << 0.0, 0.0, 0.0;
    surface.vertices.col(2 * sides + 1) << 0.0, 0.0, 2.0;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / sides;
        surface.vertices.col(i) << std::cos(angle), std::sin(angle), 0.0;
        surface.vertices.col(sides + i) << std::cos(angle), std::sin(angle), 2.0;
        const int next = (i + 1) % sides;
        surface.triangles.col(4 * i) << i, next, sides + i;
        surface.triangles.col(4 * i + 1) << next, sides + next, sides + i;
        surface.triangles.col(4 * i + 2) << 2 * sides, next, i;
        surface.triangles.col(4 * i + 3) << 2 * sides + 1, sides + i, sides + next;
    }
    return surface;
}

TEST(SurfacePatch, IsTheWholeFlatFaceAndNothingElse) {
    const SurfacePatches box(box_surface(Box{{0.0, 0.0, 0.0}, {4.0, 2.0, 1.0}}));
    const auto under = box.nearest({4.5, 1.0, 0.4});
    EXPECT_EQ(box.normal(under.triangle), Eigen::Vector3d::UnitX());
    const std::vector<int> face = box.around(under.triangle);
    EXPECT_EQ(face.size(), 2u);
    const Box around = box.box_around(face);
    const double margin = patch_policy.margin * 4.0;
    EXPECT_TRUE(around.lowest.isApprox(Eigen::Vector3d(4.0 - margin, -margin, -margin)));
    EXPECT_TRUE(around.highest.isApprox(Eigen::Vector3d(4.0 + margin, 2.0 + margin, 1.0 + margin)));
}

TEST(SurfacePatch, EndsWhereARoundTurnsByMoreThanTheAngle) {
    const SurfacePatches tube(prism(36));  // 10 degrees between neighbours
    const auto end = tube.nearest({0.0, 0.0, 3.0});
    EXPECT_EQ(tube.around(end.triangle).size(), 36u);
    const auto side = tube.nearest({2.0, 0.1, 1.0});
    // Two sides on either side of the one under the mouse, of two triangles each.
    EXPECT_EQ(tube.around(side.triangle).size(), 10u);
    const SurfacePatches coarse(prism(8));
    EXPECT_EQ(coarse.around(coarse.nearest({2.0, 0.1, 1.0}).triangle).size(), 2u);
}

}  // namespace
}  // namespace myo::mesh
