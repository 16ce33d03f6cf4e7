#include "mesh/closest_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "mesh/face_shape.hpp"
#include "mesh/test_meshes.hpp"

namespace myo::mesh {
namespace {

TEST(FaceShape, SumsToOneAndGradientMatchesDifferences) {
    const Eigen::Vector2d uv(0.31, 0.22);
    for (const int nodes : {3, 4, 6}) {
        EXPECT_NEAR(face_shape(nodes, uv).sum(), 1.0, 1e-15);
        const Eigen::MatrixX2d G = face_shape_gradient(nodes, uv);
        for (int a = 0; a < 2; ++a) {
            const Eigen::Vector2d h = 1e-6 * Eigen::Vector2d::Unit(a);
            const Eigen::VectorXd difference = (face_shape(nodes, uv + h) - face_shape(nodes, uv - h)) / 2e-6;
            EXPECT_LT((G.col(a) - difference).norm(), 1e-9);
            EXPECT_GT(G.col(a).norm(), 0.1);
        }
    }
}

// A fine sampling of every face, 3 x points.
Eigen::Matrix3Xd samples_of(const VolumeMesh& mesh, const BoundaryFaces& faces, int n) {
    const int nodes = static_cast<int>(faces.nodes.rows());
    std::vector<Eigen::VectorXd> shapes;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= (nodes == 4 ? n : n - i); ++j)
            shapes.push_back(face_shape(nodes, {static_cast<double>(i) / n, static_cast<double>(j) / n}));
    Eigen::MatrixXd N(nodes, shapes.size());
    for (std::size_t k = 0; k < shapes.size(); ++k) N.col(static_cast<Eigen::Index>(k)) = shapes[k];
    Eigen::Matrix3Xd points(3, N.cols() * faces.count());
    for (Eigen::Index f = 0; f < faces.count(); ++f)
        points.middleCols(f * N.cols(), N.cols()) = mesh.nodes(Eigen::all, faces.nodes.col(f)) * N;
    return points;
}

void check_against_sampling(const VolumeMesh& mesh, int points) {
    const BoundaryFaces faces = boundary_faces(mesh);
    const BoundaryLocator locator(mesh, faces);
    const Box box = bounding_box(mesh.nodes);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-0.3, 1.3);
    const int n = 40;
    const Eigen::Matrix3Xd samples = samples_of(mesh, faces, n);
    for (int k = 0; k < points; ++k) {
        const Eigen::Vector3d t(uniform(random), uniform(random), uniform(random));
        const Eigen::Vector3d p = box.lowest + t.cwiseProduct(box.size());
        const BoundaryPoint found = closest_boundary_point(locator, p);
        const double sampled = std::sqrt((samples.colwise() - p).colwise().squaredNorm().minCoeff());
        EXPECT_LE(found.distance, sampled + 1e-15) << to_string(mesh.type);
        EXPECT_GE(found.distance, sampled - 1.5 * box.size().maxCoeff() / n);
        EXPECT_NEAR(found.weights.sum(), 1.0, 1e-13);
        EXPECT_LT((mesh.nodes(Eigen::all, found.nodes) * found.weights - found.point).norm(), 1e-15);
        EXPECT_NEAR((found.point - p).norm(), found.distance, 1e-15);
        EXPECT_GE(found.parameters.minCoeff(), 0.0);
        EXPECT_EQ(found.cell, faces.cell[found.face]);
    }
}

TEST(ClosestPoint, NeverFartherThanAFineSampling) {
    for (const VolumeMesh& mesh : test::one_of_each()) {
        check_against_sampling(mesh, 60);
        check_against_sampling(test::bent(test::rotated(mesh), 6.0), 60);
    }
}

TEST(ClosestPoint, BoxHasAClosedForm) {
    const Box box = test::unequal_box();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-0.5, 1.5);
    for (const VolumeMesh& mesh : test::one_of_each()) {
        const BoundaryLocator locator(mesh);
        for (int k = 0; k < 300; ++k) {
            const Eigen::Vector3d t(uniform(random), uniform(random), uniform(random));
            const Eigen::Vector3d p = box.lowest + t.cwiseProduct(box.size());
            const Eigen::Vector3d clamped = p.cwiseMax(box.lowest).cwiseMin(box.highest);
            const double inside = (p - box.lowest).cwiseMin(box.highest - p).minCoeff();
            const double expected = inside > 0.0 ? inside : (p - clamped).norm();
            EXPECT_NEAR(closest_boundary_point(locator, p).distance, expected, 1e-15);
        }
    }
}

TEST(ClosestPoint, BindsInsideAFaceAndNotToANode) {
    const VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {1, 1, 1}}, {1, 1, 1});
    const BoundaryPoint found = closest_boundary_point(BoundaryLocator(mesh), {1.2, 0.3, 0.6});
    EXPECT_LT((found.point - Eigen::Vector3d(1.0, 0.3, 0.6)).norm(), 1e-14);
    EXPECT_NEAR(found.distance, 0.2, 1e-14);
    std::vector<double> weights(found.weights.begin(), found.weights.end());
    std::sort(weights.begin(), weights.end());
    EXPECT_NEAR(weights[0], 0.12, 1e-14);
    EXPECT_NEAR(weights[3], 0.42, 1e-14);
}

}  // namespace
}  // namespace myo::mesh
