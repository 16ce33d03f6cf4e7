#include "mesh/clipping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesh/box_tree.hpp"
#include "mesh/face_quadrature.hpp"
#include "mesh/face_shape.hpp"
#include "mesh/mesh_repair.hpp"
#include "mesh/quality.hpp"
#include "mesh/region.hpp"
#include "mesh/test_meshes.hpp"

namespace myo::mesh {
namespace {

constexpr double on_side = 1e-12;

/// Area of a flat polygon.
double area_of(const Polygon& polygon) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += 0.5 * (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
    return sum.norm();
}

TEST(ClipToBox, CutsASquare) {
    const Polygon square{{0, 0, 0.5}, {2, 0, 0.5}, {2, 2, 0.5}, {0, 2, 0.5}};
    EXPECT_NEAR(area_of(clip_to_box(square, {{0.5, 1.0, 0.0}, {3.0, 3.0, 1.0}}, on_side)), 1.5, 1e-15);
    EXPECT_NEAR(area_of(clip_to_box(square, {{-1, -1, -1}, {3, 3, 3}}, on_side)), 4.0, 1e-15);
    // A polygon that lies in a side is kept, one beyond it is not.
    EXPECT_NEAR(area_of(clip_to_box(square, {{0, 0, 0.5}, {2, 2, 1}}, on_side)), 4.0, 1e-15);
    EXPECT_TRUE(clip_to_box(square, {{0, 0, 0.6}, {2, 2, 1}}, on_side).empty());
    // The corner x + y <= 1 of a triangle in a unit box.
    const Polygon triangle{{-1, 0, 0}, {2, 0, 0}, {-1, 3, 0}};
    EXPECT_NEAR(area_of(clip_to_box(triangle, {{0, 0, -1}, {1, 1, 1}}, on_side)), 1.0, 1e-14);
}

TEST(TetrahedronInBox, HasTheMomentsOfTheWhole) {
    Eigen::Matrix<double, 3, 4> corners;
    corners << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
    const ClippedVolume whole = tetrahedron_in_box(corners, {{-1, -1, -1}, {2, 2, 2}}, on_side);
    EXPECT_NEAR(whole.volume_m3, 1.0 / 6.0, 1e-15);
    EXPECT_LT((whole.centre_m() - Eigen::Vector3d::Constant(0.25)).norm(), 1e-15);
    // Integrals over the unit tetrahedron: x^2 1/60, x y 1/120.
    EXPECT_NEAR(whole.second_moment_m5(0, 0), 1.0 / 60.0, 1e-16);
    EXPECT_NEAR(whole.second_moment_m5(0, 1), 1.0 / 120.0, 1e-16);
    // Either orientation counts as positive.
    corners.col(1).swap(corners.col(2));
    EXPECT_NEAR(tetrahedron_in_box(corners, {{-1, -1, -1}, {2, 2, 2}}, on_side).volume_m3, 1.0 / 6.0, 1e-15);
    EXPECT_EQ(tetrahedron_in_box(corners, {{2, 2, 2}, {3, 3, 3}}, on_side).volume_m3, 0.0);
}

/// A corner of size s cut off the unit tetrahedron is similar to it: volume s^3 / 6.
TEST(TetrahedronInBox, CutsSimilarCorners) {
    Eigen::Matrix<double, 3, 4> corners;
    corners << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
    for (const double from : {0.2, 0.5, 0.9}) {
        const double s = 1.0 - from;
        EXPECT_NEAR(tetrahedron_in_box(corners, {{from, -1, -1}, {2, 2, 2}}, on_side).volume_m3, s * s * s / 6.0,
                    1e-15);
    }
}

TEST(TetrahedronInBox, OctantsAddUp) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    for (int trial = 0; trial < 20; ++trial) {
        Eigen::Matrix<double, 3, 4> corners;
        for (double& x : corners.reshaped()) x = place(random);
        const ClippedVolume whole = tetrahedron_in_box(corners, {{-1, -1, -1}, {1, 1, 1}}, on_side);
        ClippedVolume sum;
        for (int octant = 0; octant < 8; ++octant) {
            Box box{{0, 0, 0}, {1, 1, 1}};
            for (int a = 0; a < 3; ++a)
                if ((octant >> a) & 1) box.lowest[a] = -1.0, box.highest[a] = 0.0;
            const ClippedVolume part = tetrahedron_in_box(corners, box, on_side);
            sum.volume_m3 += part.volume_m3;
            sum.moment_m4 += part.moment_m4;
            sum.second_moment_m5 += part.second_moment_m5;
        }
        EXPECT_NEAR(sum.volume_m3, whole.volume_m3, 1e-14);
        EXPECT_LT((sum.moment_m4 - whole.moment_m4).norm(), 1e-14);
        EXPECT_LT((sum.second_moment_m5 - whole.second_moment_m5).norm(), 1e-14);
    }
}

TEST(CellInBox, HalvesOfABoxHaveHalfOfIt) {
    for (const VolumeMesh& mesh : test::one_of_each()) {
        const Box box = test::unequal_box();
        Box half = box;
        half.highest.x() = 0.5 * (box.lowest.x() + box.highest.x());
        const double tolerance = region_tolerance(mesh);
        double volume = 0.0;
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();
        for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
            const ClippedVolume part = cell_in_box(mesh, c, half, tolerance);
            volume += part.volume_m3;
            moment += part.moment_m4;
        }
        EXPECT_NEAR(volume, 0.5 * box.size().prod(), 1e-18);
        EXPECT_LT((moment / volume - 0.5 * (half.lowest + half.highest)).norm(), 1e-13);
        EXPECT_NEAR(volume_fractions(mesh, half).dot(cell_volumes(mesh)), volume, 1e-18);
    }
}

/// Integral of u^i v^j over the triangle: i! j! / (i + j + 2)!; over the unit square: 1 / ((i + 1) (j + 1)).
TEST(FaceQuadrature, IsExactToItsDegree) {
    const auto integral = [](int nodes, int i, int j) {
        double sum = 0.0;
        for (const FacePoint& point : face_quadrature(nodes))
            sum += point.weight * std::pow(point.uv[0], i) * std::pow(point.uv[1], j);
        return sum;
    };
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; i + j <= 4; ++j) {
            const double exact = std::tgamma(i + 1.0) * std::tgamma(j + 1.0) / std::tgamma(i + j + 3.0);
            EXPECT_NEAR(integral(3, i, j), exact, 1e-14) << i << " " << j;
            EXPECT_EQ(integral(6, i, j), integral(3, i, j));
        }
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j) EXPECT_NEAR(integral(4, i, j), 1.0 / ((i + 1.0) * (j + 1.0)), 1e-15);
    // Not beyond: the rules are as small as their degree allows.
    EXPECT_GT(std::abs(integral(4, 4, 0) - 0.2), 1e-4);
    EXPECT_GT(std::abs(integral(3, 6, 0) - 1.0 / 56.0), 1e-6);
}

TEST(FaceShape, ReproducesPolynomialsOfItsDegree) {
    // Positions of the nodes in parameters.
    const std::vector<Eigen::Vector2d> corners{{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    const std::vector<Eigen::Vector2d> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Eigen::Vector2d at(0.3, 0.2);
    const auto quadratic = [](const Eigen::Vector2d& p) { return 1.0 + p[0] * p[0] - 2.0 * p[0] * p[1] + p[1]; };
    const auto bilinear = [](const Eigen::Vector2d& p) { return 1.0 + p[0] - 2.0 * p[0] * p[1]; };
    double six = 0.0, four = 0.0, three = 0.0;
    for (int i = 0; i < 6; ++i) six += face_shape(6, at)[i] * quadratic(corners[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 4; ++i) four += face_shape(4, at)[i] * bilinear(square[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 3; ++i) three += face_shape(3, at)[i] * (2.0 * corners[static_cast<std::size_t>(i)][0] + 1.0);
    EXPECT_NEAR(six, quadratic(at), 1e-15);
    EXPECT_NEAR(four, bilinear(at), 1e-15);
    EXPECT_NEAR(three, 1.6, 1e-15);
}

TEST(BoxTree, FindsWhatASearchOfAllFinds) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(0.0, 1.0), size(0.0, 0.15);
    std::vector<Box> boxes;
    for (int i = 0; i < 120; ++i) {
        const Eigen::Vector3d low(place(random), place(random), place(random));
        boxes.push_back({low, low + Eigen::Vector3d(size(random), size(random), size(random))});
    }
    const BoxTree tree(boxes);
    const auto overlap = [&](int i, int j, double margin) {
        const Box &a = boxes[static_cast<std::size_t>(i)], &b = boxes[static_cast<std::size_t>(j)];
        return ((a.lowest - b.highest).array() <= margin).all() && ((b.lowest - a.highest).array() <= margin).all();
    };
    int expected = 0, found = 0;
    for (int i = 0; i < 120; ++i)
        for (int j = i + 1; j < 120; ++j) expected += overlap(i, j, 0.0);
    tree.overlapping_pairs(0.0, [&](int i, int j) {
        EXPECT_LT(i, j);
        EXPECT_TRUE(overlap(i, j, 0.0));
        ++found;
        return true;
    });
    EXPECT_EQ(found, expected);
    EXPECT_GT(found, 20);
    for (int k = 0; k < 50; ++k) {
        const Eigen::Vector3d p(place(random), place(random), place(random));
        const auto distance = [&](int i) {
            const Box& b = boxes[static_cast<std::size_t>(i)];
            return (p - p.cwiseMax(b.lowest).cwiseMin(b.highest)).squaredNorm();
        };
        int best = 0;
        for (int i = 1; i < 120; ++i)
            if (distance(i) < distance(best)) best = i;
        EXPECT_EQ(tree.nearest(p, distance), best);
    }
    EXPECT_EQ(BoxTree({}).nearest({0, 0, 0}, [](int) { return 0.0; }), -1);
}

TEST(MeshRepair, TurnsCellsAndDropsUnusedNodes) {
    for (const VolumeMesh& mesh : test::one_of_each()) {
        VolumeMesh mirrored = mesh;
        mirrored.nodes.row(0) *= -1.0;
        EXPECT_LT(cell_volumes(mirrored).maxCoeff(), 0.0);
        mirrored.nodes.conservativeResize(3, mesh.node_count() + 1);
        mirrored.nodes.col(mesh.node_count()).setZero();
        const Result<VolumeMesh> repaired = with_positive_cells(mirrored, "here");
        ASSERT_TRUE(repaired);
        EXPECT_EQ(repaired->node_count(), mesh.node_count());
        EXPECT_LT((cell_volumes(*repaired) - cell_volumes(mesh)).norm(), 1e-18);
        mirrored.cells(0, 0) = 1 << 20;
        ASSERT_FALSE(with_positive_cells(mirrored, "here"));
        EXPECT_EQ(with_positive_cells(mirrored, "here").error().where, "here");
    }
}

TEST(Quality, DoesNotChangeWithSizePlaceOrRotation) {
    for (const VolumeMesh& mesh : test::one_of_each()) {
        VolumeMesh moved = test::rotated(mesh);
        moved.nodes = (3.0 * moved.nodes).colwise() + Eigen::Vector3d(1.0, -2.0, 0.5);
        EXPECT_LT((cell_shapes(moved) - cell_shapes(mesh)).norm(), 1e-11);
        EXPECT_NEAR(mean_edge_length(moved), 3.0 * mean_edge_length(mesh), 1e-12);
        EXPECT_LT((cell_volumes(moved) - 27.0 * cell_volumes(mesh)).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace myo::mesh
