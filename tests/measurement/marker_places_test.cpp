#include "measurement/marker_places.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "measurement/registration.hpp"
#include "mesh/box_mesh.hpp"

// Markers that sit a little off their declared places.

namespace myo::measurement::marker_places_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const Box beam{{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}};
/// One in a face, one on a stalk.
const std::vector<Vector3d> rest{{0.0612, 0.0, 0.0113}, {0.035, 0.014, 0.034}};
const Vector3d shift(0.0011, 0.0, -0.0007);  // within both faces where it counts

Vector3d position(const MarkerSet& set, std::size_t marker, const Matrix3Xd& x) {
    return marker_position(set.bindings[marker], x(Eigen::all, set.bindings[marker].nodes));
}

/// The box bent about y into an arc.
Matrix3Xd bent(Matrix3Xd X) {
    const double radius = 0.08;
    for (auto point : X.colwise()) {
        const double angle = point.x() / radius, arm = radius - point.z();
        point = Vector3d(arm * std::sin(angle), point.y(), radius - arm * std::cos(angle));
    }
    return X;
}

TEST(MarkerPlaces, MoveWithTheMaterialAtThePlace) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(beam, {5, 2, 2});
    const MarkerSet declared = marker_set(mesh, rest), placed = placed_markers(mesh, declared, {shift, shift});
    Eigen::Matrix3d F;
    F << 1.1, 0.2, -0.1, 0.05, 0.9, 0.3, 0.0, -0.2, 1.05;
    for (std::size_t m = 0; m < 2; ++m) {
        EXPECT_LT((position(placed, m, mesh.nodes) - rest[m] - shift).norm(), 1e-14);
        const Vector3d change = position(placed, m, F * mesh.nodes) - position(declared, m, F * mesh.nodes);
        EXPECT_LT((change - F * shift).norm(), 1e-14);
        EXPECT_GT((change - shift).norm(), 1e-4);
    }
    EXPECT_EQ(placed_markers(mesh, declared, {}).bindings[0].weights, declared.bindings[0].weights);
}

TEST(MarkerPlaces, AreThoseOfAMarkerBoundThere) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(beam, {5, 2, 2});
    const Matrix3Xd x = bent(mesh.nodes);
    const MarkerSet declared = marker_set(mesh, {rest[0]});
    const Vector3d far(0.031, 0.0, 0.007);  // in another cell
    const Vector3d bound = position(marker_set(mesh, {rest[0] + far}), 0, x);
    EXPECT_LT((position(placed_markers(mesh, declared, {far}), 0, x) - bound).norm(), 1e-13);
}

TEST(MarkerPlaces, DerivativesAreColumnsOfTheDeformationGradient) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(beam, {5, 2, 2});
    const Matrix3Xd x = bent(mesh.nodes);
    const MarkerSet declared = marker_set(mesh, {rest[0]}), columns = place_derivatives(declared);
    ASSERT_EQ(columns.bindings.size(), 3u);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = [&](double by) {
            const Vector3d place = by * Vector3d::Unit(static_cast<Index>(axis));
            return position(placed_markers(mesh, declared, {place}), 0, x);
        };
        EXPECT_LT((position(columns, axis, x) - (at(1e-5) - at(-1e-5)) / 2e-5).norm(), 1e-8) << axis;
        if (axis == 1) continue;  // the axis of bending, along which nothing stretches
        EXPECT_GT((position(columns, axis, x) - Vector3d::Unit(static_cast<Index>(axis))).norm(), 0.1) << axis;
    }
}

TEST(MarkerPlaces, TurnARegistrationToThem) {
    Matrix3Xd to(3, 5);
    to << 0.0, 0.1, 0.1, 0.05, 0.0, 0.0, 0.0, 0.03, 0.03, 0.03, 0.0, 0.01, 0.03, 0.02, 0.03;
    const Eigen::VectorXd weights = (Eigen::VectorXd(5) << 1.0, 1.0, 0.0, 1.0, 1.0).finished();
    const RigidMotion elsewhere{Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix(),
                                Vector3d(0.4, -0.2, 0.9)};
    const Matrix3Xd from = elsewhere.inverse().apply_all(to);
    const Eigen::MatrixXd slopes = d_registration_d_to(to, weights);
    const double h = 1e-5;
    for (Index k = 0; k < 15; ++k) {
        const auto moved = [&](double by) {
            Matrix3Xd there = to;
            there(k % 3, k / 3) += by;
            return rigid_registration(from, there, weights)->motion.apply_all(from);
        };
        const Matrix3Xd difference = (moved(h) - moved(-h)) / (2.0 * h);
        for (Index i = 0; i < 5; ++i)
            EXPECT_LT((slopes.col(k).head<3>() + slopes.col(k).tail<3>().cross(Vector3d(to.col(i))) - difference.col(i))
                          .norm(),
                      1e-6);
    }
    EXPECT_TRUE(slopes.middleCols<3>(6).isZero(0.0));  // of the marker that was not seen
    EXPECT_GT(slopes.leftCols<3>().norm(), 0.1);
}

}  // namespace
}  // namespace myo::measurement::marker_places_test
