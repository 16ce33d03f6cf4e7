#include "experiment/cavities.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace myo::experiment {
namespace {

/// A box with boxes inside, whose surfaces face into them.
mesh::SurfaceMesh hollow(const Box& outer, const std::vector<Box>& inner) {
    mesh::SurfaceMesh all = mesh::box_surface(outer);
    for (const Box& box : inner) {
        mesh::SurfaceMesh wall = mesh::box_surface(box);
        wall.triangles.row(1).swap(wall.triangles.row(2));
        wall.triangles.array() += static_cast<int>(all.vertices.cols());
        Eigen::Matrix3Xd vertices(3, all.vertices.cols() + 8);
        vertices << all.vertices, wall.vertices;
        Eigen::Matrix3Xi triangles(3, all.triangles.cols() + 12);
        triangles << all.triangles, wall.triangles;
        all = {vertices, triangles};
    }
    return all;
}

TEST(SurfaceCavities, AreFoundWithVolumeWallAndAPointInside) {
    const std::vector<Box> inner{{{0.01, 0.01, 0.01}, {0.03, 0.02, 0.015}}, {{0.05, 0.01, 0.005}, {0.09, 0.02, 0.025}}};
    const mesh::SurfaceMesh surface = hollow({{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}}, inner);
    const BodyQueries body(surface);
    const std::vector<SurfaceCavity> found = surface_cavities(body);
    ASSERT_EQ(found.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const Eigen::Vector3d size = inner[i].size();
        EXPECT_NEAR(found[i].cavity.volume_m3, size.prod(), 1e-15);
        EXPECT_NEAR(found[i].cavity.area_m2, 2.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()),
                    1e-12);
        EXPECT_TRUE(inner[i].contains(found[i].inside_m));
        EXPECT_EQ(found[i].cavity.wall.triangles.cols(), 12);
    }
}

TEST(SurfaceCavities, AreNoneInASolidBody) {
    const mesh::SurfaceMesh solid = hollow({{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}}, {});
    EXPECT_TRUE(surface_cavities(BodyQueries(solid)).empty());
}

/// A point found in a cavity serves as chamber.inside_m.
TEST(SurfaceCavities, GivePointsThatDeclareChambers) {
    const mesh::SurfaceMesh surface = hollow({{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}},
                                             {{{0.01, 0.01, 0.01}, {0.09, 0.02, 0.02}}});
    const BodyQueries body(surface);
    Experiment experiment;
    experiment.chambers.push_back({"air", surface_cavities(body).at(0).inside_m});
    const Result<std::vector<Cavity>> declared = chamber_cavities(experiment, body);
    ASSERT_TRUE(declared) << declared.error().text();
    EXPECT_NEAR((*declared)[0].volume_m3, 0.08 * 0.01 * 0.01, 1e-15);
}

}  // namespace
}  // namespace myo::experiment
