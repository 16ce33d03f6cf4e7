#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/box_tree.hpp"
#include "mesh/face_shape.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_distance.hpp"

// Nearest points: of a triangle region by region, of surfaces, of curved and degenerate faces, and the tree behind
// them.

namespace myo::mesh::nearest_point_test {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;

struct Foot {
    Vector3d from, to;
};

/// A triangle with legs of 4 along x and 3 along y; one point over each corner, side and the inside.
const std::vector<Foot> feet{
    {{-1, -1, 2}, {0, 0, 0}}, {{6, -1, 0}, {4, 0, 0}}, {{-1, 5, 1}, {0, 3, 0}},      {{2, -1, 1}, {2, 0, 0}},
    {{-2, 1, -1}, {0, 1, 0}}, {{1, 1, -7}, {1, 1, 0}}, {{4, 3, 5}, {2.56, 1.08, 0}}, {{0, 0, 0}, {0, 0, 0}},
};

TEST(NearestInTriangle, IsRightInEveryRegionWhateverTheOrderOfCorners) {
    const std::array<Vector3d, 3> corners{Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 3, 0)};
    const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Vector3d(2, -1, 3).normalized()).toRotationMatrix();
    const Vector3d shift(7, -2, 0.5);
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
        const auto corner = [&](std::size_t i) -> Vector3d { return R * corners[order[i]] + shift; };
        for (const Foot& foot : feet) {
            const Vector3d found = nearest_in_triangle(corner(0), corner(1), corner(2), R * foot.from + shift);
            EXPECT_LT((found - (R * foot.to + shift)).norm(), 1e-14) << foot.from.transpose();
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

/// Corners that coincide leave a segment or a point.
TEST(NearestInTriangle, WithoutAreaIsThatOfItsSides) {
    const Vector3d a(1, 2, 3), b(3, 2, 3);
    for (const auto& [from, to] : {Foot{{0, 5, 0}, a}, {{9, 5, 0}, b}, {{2.5, 7, 1}, {2.5, 2, 3}}, {a, a}, {b, b}}) {
        EXPECT_EQ(nearest_in_triangle(a, b, b, from), to);
        EXPECT_EQ(nearest_in_triangle(a, b, a, from), to);
        EXPECT_EQ(nearest_in_triangle(a, a, b, from), to);
        EXPECT_EQ(nearest_in_triangle(a, a, a, from), a);
    }
}

TEST(SurfaceDistance, LooksAtTrianglesWithoutAreaAsWell) {
    SurfaceMesh line{Matrix3Xd(3, 3), Eigen::Matrix3Xi(3, 1)};
    line.vertices << 1, 1, 3, 2, 2, 2, 3, 3, 3;
    line.triangles << 0, 1, 2;
    const SurfaceDistance::Nearest nearest = SurfaceDistance(line).nearest({2, 2, 5});
    EXPECT_EQ(nearest.triangle, 0);
    EXPECT_EQ(nearest.distance, 2.0);
    EXPECT_EQ(nearest.point, Vector3d(2, 2, 3));
}

/// Only the centre of this triangle is a third away from the cube: its corners lie on it, its middles a quarter off.
TEST(SurfaceDistance, LargestIsMeasuredWithinTriangles) {
    const SurfaceDistance cube(box_surface({{0, 0, 0}, {1, 1, 1}}));
    SurfaceMesh across{Matrix3Xd(3, 3), Eigen::Matrix3Xi(3, 1)};
    across.vertices << 0, 1, 0.5, 0.5, 0.5, 0.5, 0, 0, 1;
    across.triangles << 0, 1, 2;
    EXPECT_NEAR(cube.largest_from(across), 1.0 / 3.0, 1e-15);
    // Turned over, other sides are measured, and the centre as before.
    EXPECT_NEAR(cube.largest_from(flipped(across)), 1.0 / 3.0, 1e-15);
    EXPECT_EQ(cube.largest_from(SurfaceMesh{Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0)}), 0.0);
}

std::vector<Box> row_of_boxes(int count, double gap) {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
        const double at = (1.0 + gap) * i;
        boxes.push_back({{at, 0, 0}, {at + 1.0, 1, 1}});
    }
    return boxes;
}

int pairs_of(const BoxTree& tree, double margin) {
    int count = 0;
    tree.overlapping_pairs(margin, [&](int, int) { return ++count > 0; });
    return count;
}

TEST(BoxTree, MarginDecidesAboutNeighbours) {
    EXPECT_EQ(pairs_of(BoxTree(row_of_boxes(20, 0.0)), 0.0), 19) << "boxes that touch overlap";
    const BoxTree apart(row_of_boxes(20, 0.25));
    EXPECT_EQ(pairs_of(apart, 0.0), 0);
    EXPECT_EQ(pairs_of(apart, 0.24), 0);
    EXPECT_EQ(pairs_of(apart, 0.26), 19);
    EXPECT_EQ(pairs_of(apart, 1.51), 19 + 18) << "the next but one is 1.5 away";
    EXPECT_EQ(pairs_of(apart, 1e3), 190);
    EXPECT_EQ(pairs_of(BoxTree({}), 1.0), 0);
    EXPECT_EQ(pairs_of(BoxTree(row_of_boxes(1, 0.0)), 1e3), 0) << "no pair of one with itself";
}

TEST(BoxTree, StopsWhenTold) {
    const BoxTree tree(row_of_boxes(40, 0.0));
    for (const int most : {1, 7}) {
        int visited = 0;
        tree.overlapping_pairs(0.0, [&](int, int) { return ++visited < most; });
        EXPECT_EQ(visited, most);
    }
}

/// Many items at one distance, in any order of the tree: the lowest number counts.
TEST(BoxTree, LowestNumberWinsTies) {
    for (const int count : {1, 4, 5, 33}) {
        std::vector<Box> boxes(static_cast<std::size_t>(count), Box{{-1, -1, -1}, {1, 1, 1}});
        const auto distance = [](int) { return 0.25; };
        EXPECT_EQ(BoxTree(boxes).nearest({3, 0, 0}, [](int) { return 4.0; }), 0) << count;
        EXPECT_EQ(BoxTree(boxes).nearest({0, 0, 0}, distance), 0) << count;
    }
    // The boxes only bound the items: the nearest box need not hold the nearest item.
    EXPECT_EQ(BoxTree(row_of_boxes(9, 0.0)).nearest({4.5, 0.5, 0.5}, [](int i) { return i == 7 ? 100.0 : 200.0; }), 7);
}

/// Points of a face are their own nearest points; a curved face finds its own parameters again.
TEST(FaceParameters, OfPointsOfAFaceAreFoundAgain) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> share(0.05, 0.45);
    Matrix3Xd quadrilateral(3, 4), quadratic(3, 6);
    quadrilateral << 0, 2, 2.3, -0.1, 0, 0.1, 1.4, 1, 0, 0.2, 0, 0.3;
    quadratic << 0, 1, 0, 0.5, 0.52, 0.02, 0, 0, 1, -0.03, 0.5, 0.5, 0, 0, 0, 0.06, 0.08, 0.05;
    for (const Matrix3Xd& X : {quadrilateral, quadratic, Matrix3Xd(quadratic.leftCols(3))})
        for (int k = 0; k < 20; ++k) {
            const Vector2d uv(share(random), share(random));
            const Vector3d x = X * face_shape(static_cast<int>(X.cols()), uv);
            EXPECT_LT((closest_face_parameters(X, x) - uv).norm(), 1e-6) << X.cols() << " nodes";
        }
}

/// A quadrilateral with two corners in one point is a triangle; one without extent is a point.
TEST(FaceParameters, StayInTheirDomainOnCollapsedFaces) {
    Matrix3Xd triangle(3, 4), point = Matrix3Xd::Constant(3, 4, 0.5);
    triangle << 0, 2, 0, 0, 0, 0, 2, 2, 0, 0, 0, 0;
    for (const Vector3d& p : {Vector3d(0.5, 0.5, 1), Vector3d(3, 3, 0), Vector3d(-1, 1, 0), Vector3d(0, 9, -2)})
        for (const Matrix3Xd& X : {triangle, point}) {
            const Vector2d uv = closest_face_parameters(X, p);
            ASSERT_TRUE(uv.allFinite());
            EXPECT_GE(uv.minCoeff(), 0.0);
            EXPECT_LE(uv.maxCoeff(), 1.0);
            const Vector3d flat = nearest_in_triangle(X.col(0), X.col(1), X.col(2), p);
            EXPECT_NEAR((X * face_shape(4, uv) - p).norm(), (flat - p).norm(), 1e-9);
        }
}

/// Rounding decides the signs of the regions there, so that the nearest point is sought on the sides.
TEST(NearestInTriangle, WithoutAreaLiesOnTheLongestSide) {
    const Vector3d a(0.3, -0.1, 0.7), b(1.4, 0.9, -0.2);
    for (int k = 0; k <= 50; ++k) {
        // Along the line and off it; beyond its ends, too.
        const double along = -0.3 + 0.032 * k;
        const Vector3d p = a + along * (b - a) + Vector3d(0.02 * k, 0.3, -0.01 * k);
        const Vector3d there = nearest_in_segment(a, b, p);
        const double at = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        EXPECT_LT((there - (a + at * (b - a))).norm(), 1e-15);
        for (const double inside : {0.0, 0.3, 0.77, 1.0}) {
            const Vector3d c = a + inside * (b - a);
            for (const Vector3d& x : {nearest_in_triangle(a, b, c, p), nearest_in_triangle(c, a, b, p),
                                      nearest_in_triangle(b, c, a, p), nearest_in_triangle(c, b, a, p)})
                EXPECT_LT((x - there).norm(), 1e-14) << k << " " << inside;
        }
        EXPECT_EQ(nearest_in_triangle(a, a, a, p), a);
    }
}

}  // namespace
}  // namespace myo::mesh::nearest_point_test
