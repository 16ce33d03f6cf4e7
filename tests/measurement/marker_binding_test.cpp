#include "measurement/marker_binding.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "measurement/observe.hpp"
#include "mesh/box_mesh.hpp"

namespace myo::measurement {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

Matrix3Xd gathered(const MarkerBinding& binding, const Matrix3Xd& x) { return x(Eigen::all, binding.nodes); }

const Box box{{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}};

std::vector<mesh::VolumeMesh> meshes() {
    return {mesh::box_hex_mesh(box, {5, 2, 2}), mesh::tet_box_mesh(box, {4, 1, 1}, mesh::CellType::tet4),
            mesh::tet_box_mesh(box, {3, 1, 1}, mesh::CellType::tet10)};
}

TEST(MarkerBinding, ReproducesAnyLinearMotionExactly) {
    Eigen::Matrix3d F;
    F << 1.1, 0.2, -0.1, 0.05, 0.9, 0.3, 0.0, -0.2, 1.05;
    const Vector3d shift(0.01, -0.02, 0.03);
    const Vector3d rest(0.0612, 0.0, 0.0113);  // inside a face, at no node
    for (const mesh::VolumeMesh& mesh : meshes()) {
        const MarkerBinding binding = bind_marker(mesh, mesh::BoundaryLocator(mesh), rest);
        const Matrix3Xd x = (F * mesh.nodes).colwise() + shift;
        EXPECT_NEAR(binding.weights.sum(), 1.0, 1e-12);
        EXPECT_LT((marker_position(binding, gathered(binding, x)) - (F * rest + shift)).norm(), 1e-12);
    }
}

TEST(MarkerBinding, TurnsAStandoffWithTheMaterial) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
    const Vector3d shift(0.2, 0.1, -0.3);
    const Vector3d rest(0.08, -0.006, 0.024);
    for (const mesh::VolumeMesh& mesh : meshes()) {
        const MarkerBinding binding = bind_marker(mesh, mesh::BoundaryLocator(mesh), rest);
        EXPECT_NEAR(binding.standoff_m(), 0.006, 1e-12);
        const Matrix3Xd x = (R * mesh.nodes).colwise() + shift;
        EXPECT_LT((marker_position(binding, gathered(binding, x)) - (R * rest + shift)).norm(), 1e-12);
        // A pure stretch moves the surface point but does not turn the stalk.
        const Matrix3Xd stretched = Vector3d(1.2, 1.1, 0.9).asDiagonal() * mesh.nodes;
        const Vector3d expected = Vector3d(1.2 * 0.08, -0.006, 0.9 * 0.024);
        EXPECT_LT((marker_position(binding, gathered(binding, stretched)) - expected).norm(), 1e-12);
    }
}

TEST(MarkerBinding, PullIsTheTransposedTangent) {
    for (const mesh::VolumeMesh& mesh : meshes())
        for (const Vector3d& rest : {Vector3d(0.08, -0.006, 0.024), Vector3d(0.0612, 0.0, 0.0113)}) {
            const MarkerBinding binding = bind_marker(mesh, mesh::BoundaryLocator(mesh), rest);
            const Matrix3Xd x = gathered(binding, mesh.nodes) +
                                0.002 * Matrix3Xd::Random(3, static_cast<Eigen::Index>(binding.nodes.size()));
            const Matrix3Xd dx = Matrix3Xd::Random(3, x.cols());
            const Vector3d pull(0.3, -1.0, 0.7);
            const double along = pull.dot(marker_tangent(binding, x, dx));
            EXPECT_NE(along, 0.0);
            EXPECT_NEAR(marker_pull(binding, x, pull).cwiseProduct(dx).sum(), along, 1e-12 * std::abs(along));
        }
}

TEST(MarkerBinding, TangentEqualsDifferences) {
    for (const mesh::VolumeMesh& mesh : meshes()) {
        const MarkerBinding binding = bind_marker(mesh, mesh::BoundaryLocator(mesh), Vector3d(0.08, -0.006, 0.024));
        const Matrix3Xd x = mesh.nodes + 0.002 * Matrix3Xd::Random(3, mesh.node_count());
        const Matrix3Xd dx = Matrix3Xd::Random(3, mesh.node_count());
        const Vector3d difference = (marker_position(binding, gathered(binding, x + 1e-6 * dx)) -
                                     marker_position(binding, gathered(binding, x - 1e-6 * dx))) /
                                    2e-6;
        const Vector3d tangent = marker_tangent(binding, gathered(binding, x), gathered(binding, dx));
        EXPECT_GT(tangent.norm(), 0.1);
        EXPECT_LT((tangent - difference).norm(), 1e-7 * difference.norm());
        EXPECT_NE(tangent, difference);
    }
}

/// A body that turns about z at a constant rate, with exact positions and velocities at the steps.
dynamics::Trace turning(const mesh::VolumeMesh& mesh, double omega, double h, double end) {
    dynamics::Trace trace;
    for (int k = 0; k * h < end + 0.5 * h; ++k) {
        const double t = k * h;
        const Eigen::Matrix3d R = Eigen::AngleAxisd(omega * t, Vector3d::UnitZ()).toRotationMatrix();
        const Matrix3Xd x = R * mesh.nodes;
        Matrix3Xd v(3, x.cols());
        for (Eigen::Index i = 0; i < x.cols(); ++i) v.col(i) = omega * Vector3d::UnitZ().cross(Vector3d(x.col(i)));
        trace.times_s.push_back(t);
        trace.positions.push_back(x);
        trace.velocities.push_back(v);
    }
    return trace;
}

double largest_error(double h) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(box, {5, 2, 2});
    const Vector3d rest(0.0612, 0.0, 0.0113);
    const MarkerSet markers = marker_set(mesh, {rest});
    const Eigen::VectorXd times = Eigen::VectorXd::LinSpaced(97, 0.0, 0.37);
    const MarkerTracks tracks = observe(turning(mesh, 10.0, h, 0.4), markers, times);
    double largest = 0.0;
    for (Eigen::Index k = 0; k < times.size(); ++k) {
        const Vector3d expected = Eigen::AngleAxisd(10.0 * times(k), Vector3d::UnitZ()) * rest;
        largest = std::max(largest, (tracks.positions[0].col(k) - expected).norm());
    }
    return largest;
}

TEST(Observe, InterpolatesBetweenStepsToFourthOrder) {
    const double coarse = largest_error(0.02), fine = largest_error(0.01);
    EXPECT_GT(fine, 0.0);
    EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3);
}

TEST(Observe, RestsBeforeTheStartAndStaysAfterTheEnd) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(box, {5, 2, 2});
    const Vector3d rest(0.0612, 0.0, 0.0113);
    const dynamics::Trace trace = turning(mesh, 10.0, 0.01, 0.1);
    const Eigen::Vector2d times(-0.5, 9.0);
    const MarkerTracks tracks = observe(trace, marker_set(mesh, {rest}), times);
    EXPECT_LT((tracks.positions[0].col(0) - rest).norm(), 1e-12);
    EXPECT_EQ(tracks.velocities[0].col(0).norm(), 0.0);
    EXPECT_LT((tracks.positions[0].col(1) - Eigen::AngleAxisd(1.0, Vector3d::UnitZ()) * rest).norm(), 1e-12);
}

}  // namespace
}  // namespace myo::measurement
