#include "viewport/picking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mesh/box_mesh.hpp"

// Rays through pixels, and the triangles that they meet.

namespace myo::ui::picking {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using viewport::Camera;
using viewport::DrawnSurface;
using viewport::Ray;
using viewport::ViewSize;

const ViewSize size{400, 300};

std::vector<Camera> cameras() {
    std::vector<Camera> all;
    for (const bool orthographic : {false, true})
        for (const double yaw : {-2.4, 0.0, 1.1})
            for (const double pitch : {-1.2, 0.0, 0.7}) {
                Camera camera;
                camera.target = {0.02, -0.01, 0.03};
                camera.distance = 0.4;
                camera.scene_radius = 0.06;
                camera.yaw = yaw;
                camera.pitch = pitch;
                camera.orthographic = orthographic;
                all.push_back(camera);
            }
    return all;
}

TEST(Ray, IsWhatFallsOnThePixelInBothProjections) {
    for (const Camera& camera : cameras())
        for (const Vector2d& pixel : {Vector2d(200.0, 150.0), Vector2d(0.0, 0.0), Vector2d(390.5, 12.25)}) {
            const Ray ray = viewport::ray_through(camera, size, pixel);
            EXPECT_NEAR(ray.direction.norm(), 1.0, 1e-12);
            for (const double s : {0.1, 0.4, 0.9}) {
                const auto seen = viewport::project(camera, size, ray.origin_m + s * ray.direction);
                ASSERT_TRUE(seen) << "in front of the eye";
                EXPECT_LT((seen->head<2>() - pixel).norm(), 1e-8);
            }
        }
}

TEST(Ray, ThroughTheMiddleMeetsTheTargetAndParallelOnesStayParallel) {
    for (const Camera& camera : cameras()) {
        const Ray middle = viewport::ray_through(camera, size, {200.0, 150.0}),
                  corner = viewport::ray_through(camera, size, {0.0, 0.0});
        const Vector3d to_target = camera.target - middle.origin_m;
        EXPECT_NEAR(to_target.dot(middle.direction), viewport::eye_distance(camera), 1e-12);
        EXPECT_LT((to_target - to_target.dot(middle.direction) * middle.direction).norm(), 1e-12);
        EXPECT_EQ((corner.direction - middle.direction).norm() < 1e-15, camera.orthographic);
        EXPECT_EQ((corner.origin_m - middle.origin_m).norm() < 1e-15, !camera.orthographic) << "all leave one eye";
    }
}

TEST(ImagePlane, ADragKeepsTheDistanceFromTheEyeAndFollowsTheMouse) {
    const Vector3d place(0.05, 0.02, -0.01);
    for (const Camera& camera : cameras()) {
        const Vector3d back = viewport::camera_axes(camera).back;
        const auto own = viewport::project(camera, size, place);
        ASSERT_TRUE(own);
        EXPECT_LT((viewport::in_image_plane(camera, size, own->head<2>(), place) - place).norm(), 1e-12);
        const Vector2d mouse(30.0, 250.0);
        const Vector3d dragged = viewport::in_image_plane(camera, size, mouse, place);
        EXPECT_NEAR(back.dot(dragged - place), 0.0, 1e-12);
        const auto seen = viewport::project(camera, size, dragged);
        ASSERT_TRUE(seen);
        EXPECT_LT((seen->head<2>() - mouse).norm(), 1e-8);
        EXPECT_NEAR(seen->z(), own->z(), 1e-12);
    }
}

/// Corners (0, 0), (1, 0), (0, 1) of y and z at each x, facing +x.
DrawnSurface triangles_facing_x(const std::vector<double>& x, Eigen::Matrix3Xd& positions) {
    DrawnSurface surface;
    positions.resize(3, static_cast<Eigen::Index>(3 * x.size()));
    for (std::size_t t = 0; t < x.size(); ++t) {
        const auto column = static_cast<Eigen::Index>(3 * t);
        positions.col(column) << x[t], 0.0, 0.0;
        positions.col(column + 1) << x[t], 1.0, 0.0;
        positions.col(column + 2) << x[t], 0.0, 1.0;
        for (int k = 0; k < 3; ++k) surface.corners.push_back(static_cast<int>(column) + k);
    }
    return surface;
}

/// From x = 2 towards the triangles.
Ray ray_at(double y, double z) { return {{2.0, y, z}, {-1.0, 0.0, 0.0}}; }

TEST(PickSurface, EdgesAndCornersBelongToTheTriangleAndNothingBeyond) {
    Eigen::Matrix3Xd positions;
    const DrawnSurface surface = triangles_facing_x({0.0}, positions);
    for (const Vector2d& inside : {Vector2d(0.25, 0.5), Vector2d(0.0, 0.5), Vector2d(0.5, 0.0), Vector2d(0.5, 0.5),
                                   Vector2d(0.0, 0.0), Vector2d(1.0, 0.0), Vector2d(0.0, 1.0)}) {
        const auto hit = viewport::pick_surface(surface, positions, ray_at(inside.x(), inside.y()));
        ASSERT_TRUE(hit) << inside.transpose();
        EXPECT_EQ(hit->triangle, 0);
        EXPECT_DOUBLE_EQ(hit->distance_m, 2.0);
        EXPECT_LT((hit->weights - Vector3d(1.0 - inside.sum(), inside.x(), inside.y())).norm(), 1e-15);
    }
    constexpr double hair = 1e-9;
    for (const Vector2d& beside : {Vector2d(-hair, 0.5), Vector2d(0.5, -hair), Vector2d(0.5 + hair, 0.5),
                                   Vector2d(1.0 + hair, 0.0), Vector2d(0.0, 1.0 + hair)})
        EXPECT_FALSE(viewport::pick_surface(surface, positions, ray_at(beside.x(), beside.y()))) << beside.transpose();
}

TEST(PickSurface, OnlyAnOpenOneHasABackAndNoneIsBehindTheEye) {
    Eigen::Matrix3Xd positions;
    DrawnSurface surface = triangles_facing_x({0.0}, positions);
    const Ray front = ray_at(0.25, 0.25), from_behind{{-2.0, 0.25, 0.25}, {1.0, 0.0, 0.0}},
              away{{2.0, 0.25, 0.25}, {1.0, 0.0, 0.0}}, within{{0.0, -1.0, 0.25}, {0.0, 1.0, 0.0}},
              on_it{{0.0, 0.25, 0.25}, {-1.0, 0.0, 0.0}};
    for (const bool closed : {true, false}) {
        surface.closed = closed;
        EXPECT_TRUE(viewport::pick_surface(surface, positions, front));
        EXPECT_EQ(viewport::pick_surface(surface, positions, from_behind).has_value(), !closed);
        EXPECT_FALSE(viewport::pick_surface(surface, positions, away));
        EXPECT_FALSE(viewport::pick_surface(surface, positions, within)) << "seen from the side it has no width";
        EXPECT_FALSE(viewport::pick_surface(surface, positions, on_it));
    }
    EXPECT_FALSE(viewport::pick_surface(DrawnSurface{}, positions, front)) << "nothing is drawn";
}

TEST(PickSurface, TheFirstOfSeveralIsMetWhateverTheirOrder) {
    for (const std::vector<double>& x : {std::vector<double>{0.0, 1.0, -1.0}, {-1.0, 0.0, 1.0}, {1.0, -1.0, 0.0}}) {
        Eigen::Matrix3Xd positions;
        const DrawnSurface surface = triangles_facing_x(x, positions);
        const auto hit = viewport::pick_surface(surface, positions, ray_at(0.3, 0.3));
        ASSERT_TRUE(hit);
        EXPECT_EQ(x[static_cast<std::size_t>(hit->triangle)], 1.0);
        EXPECT_DOUBLE_EQ(hit->distance_m, 1.0);
    }
}

TEST(PickSurface, TheSamePointOfTheMaterialIsFoundInAnotherShape) {
    Eigen::Matrix3Xd positions;
    const DrawnSurface surface = triangles_facing_x({5.0, 0.0}, positions);
    const auto hit = viewport::pick_surface(surface, positions, ray_at(0.25, 0.5));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->triangle, 1) << "the other one lies behind the ray's origin";
    Eigen::Matrix3d stretch;
    stretch << 1.0, 0.2, 0.0, -0.3, 2.0, 0.5, 0.0, 0.1, 0.7;
    const Vector3d shift(3.0, -1.0, 2.0);
    const Eigen::Matrix3Xd moved = (stretch * positions).colwise() + shift;
    EXPECT_LT((hit->place(surface, moved) - (stretch * Vector3d(0.0, 0.25, 0.5) + shift)).norm(), 1e-12);
}

TEST(PickSurface, ARayThroughABodyMeetsItOnceOnTheNearSide) {
    // Whole numbers, so that nothing is rounded on an edge.
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh({{0.0, 0.0, 0.0}, {3.0, 1.0, 1.0}}, {3, 1, 1});
    const DrawnSurface surface = viewport::drawn_surface(mesh::boundary_faces(mesh));
    // On edges between elements, on those of the body and on the diagonals of faces there is no gap.
    for (const double y : {0.0, 0.25, 0.5, 1.0})
        for (const double x : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0}) {
            const auto hit = viewport::pick_surface(surface, mesh.nodes, {{x, y, 10.0}, {0.0, 0.0, -1.0}});
            ASSERT_TRUE(hit) << x << ", " << y;
            EXPECT_DOUBLE_EQ(hit->distance_m, 9.0);
            EXPECT_DOUBLE_EQ(hit->weights.sum(), 1.0);
        }
    // From the middle of the body outwards there is nothing to be seen.
    EXPECT_FALSE(viewport::pick_surface(surface, mesh.nodes, {{1.5, 0.5, 0.5}, {0.0, 0.0, -1.0}}));
}

}  // namespace
}  // namespace myo::ui::picking
