#include "model/contact.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/distance_field.hpp"
#include "model/force_of.hpp"
#include "model/loaded_face.hpp"
#include "model/one_sided.hpp"
#include "support/beam.hpp"
#include "support/differences.hpp"

namespace myo::model::contact_tests {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct Obstacle {
    const char* name;
    DistanceField field;
};
const std::vector<Obstacle> obstacles{
    {"plane", plane_distance({0.1, 0.2, -0.1}, {0.0, -3.0, 4.0})},
    {"ball", sphere_distance({0.1, 0.2, -0.1}, 0.3)},
    {"box", box_distance({-0.5, -0.4, -0.3}, {0.6, 0.3, 0.2}, 0.1)},
};
/// Beside faces, edges and corners of the box, and near the plane and the ball; none on a side where pieces meet.
const std::vector<Vector3d> places{{0.1, -0.1, 0.5}, {0.3, 0.9, -0.05},  {0.9, 0.8, 0.05},   {-0.9, 0.1, 0.8},
                                   {0.9, 0.7, 0.6},  {-1.2, -0.8, -0.9}, {0.57, 0.27, 0.17}, {0.1, 0.28, 0.05}};

/// The normal is the gradient of the distance, the curvature that of the normal.
TEST(DistanceFields, HaveTheirDerivatives) {
    for (const Obstacle& obstacle : obstacles)
        for (const Vector3d& at : places) {
            const SignedDistance here = obstacle.field(at);
            const MatrixXd slope = test::central_differences(
                [&](const VectorXd& x) { return VectorXd::Constant(1, obstacle.field(x).distance_m); }, at, 1e-6);
            EXPECT_LT((slope.transpose() - here.normal).norm(), 1e-8) << obstacle.name << " " << at.transpose();
            const MatrixXd turn = test::central_differences(
                [&](const VectorXd& x) { return VectorXd(obstacle.field(x).normal); }, at, 1e-6);
            EXPECT_LT((turn - here.curvature_1_m).norm(), 1e-7) << obstacle.name << " " << at.transpose();
            EXPECT_NEAR(here.normal.norm(), 1.0, 1e-14);
            EXPECT_LT((here.curvature_1_m * here.normal).norm(), 1e-13) << "along its normal the distance is linear";
            // One step of the distance against the normal leads to the surface.
            if (here.distance_m > 0.0) {
                EXPECT_NEAR(obstacle.field(at - here.distance_m * here.normal).distance_m, 0.0, 1e-14) << obstacle.name;
            }
        }
}

TEST(DistanceFields, OfPlaneAndBallAreThoseOfTheTextbook) {
    // 3-4-5: the normal has any length.
    const DistanceField plane = plane_distance({1.0, 0.0, 0.0}, {3.0, 4.0, 0.0});
    EXPECT_NEAR(plane({1.0, 5.0, 9.0}).distance_m, 4.0, 1e-15);
    EXPECT_NEAR(plane({-4.0, 0.0, 1.0}).distance_m, -3.0, 1e-15) << "no far side";
    const DistanceField ball = sphere_distance({1.0, 0.0, 0.0}, 2.0);
    EXPECT_NEAR(ball({1.0, 3.0, 4.0}).distance_m, 3.0, 1e-15);
    EXPECT_NEAR(ball({1.0, 0.0, -0.5}).distance_m, -1.5, 1e-15);
    EXPECT_LT((ball({1.0, 0.0, -0.5}).normal + Vector3d::UnitZ()).norm(), 1e-15) << "out on the side where it is";
    EXPECT_NEAR(ball({1.0, 0.0, 4.0}).curvature_1_m.trace(), 2.0 / 4.0, 1e-15);
    const SignedDistance centre = ball({1.0, 0.0, 0.0});
    EXPECT_EQ(centre.distance_m, -2.0);
    EXPECT_EQ(centre.normal.norm(), 1.0);
    EXPECT_TRUE(centre.curvature_1_m.allFinite());
}

/// Mirror images about the middle of the box have mirrored distances; beyond its corner one sees the small ball there.
TEST(DistanceFields, OfABoxAreThoseOfItsMirrorImages) {
    const DistanceField box = box_distance({-0.5, -0.4, -0.3}, {0.5, 0.4, 0.3}, 0.1);
    for (const Vector3d& at : places)
        for (int axis = 0; axis < 3; ++axis) {
            Matrix3d mirror = Matrix3d::Identity();
            mirror(axis, axis) = -1.0;
            EXPECT_EQ(box(mirror * at).distance_m, box(at).distance_m);
            EXPECT_LT((box(mirror * at).normal - mirror * box(at).normal).norm(), 1e-15);
        }
    const Vector3d corner(0.4, 0.3, 0.2);  // centre of its rounding
    EXPECT_NEAR(box(corner + Vector3d(0.2, 0.4, 0.4)).distance_m, 0.6 - 0.1, 1e-15);
    EXPECT_NEAR(box(Vector3d::Zero()).distance_m, -0.3, 1e-15) << "the nearest face is the way out";
    EXPECT_NEAR(box({0.3, 0.0, 0.19}).distance_m, -0.11, 1e-15);
    EXPECT_EQ(box({0.35, 0.0, 0.0}).normal, Vector3d(Vector3d::UnitX()));
}

/// A free brick whose lower side alone can touch what is below.
struct Brick {
    BodyPointer body;
    std::vector<int> lower;
    double area_m2 = 0.06 * 0.03;

    explicit Brick(fem::ElementKind kind) {
        test::BeamSpec spec;
        spec.kind = kind;
        spec.cells = {2, 1, 1};
        spec.size = {0.06, 0.03, 0.02};
        spec.clamped = false;
        body = test::make_beam(spec).body;
        std::vector<int> nodes;
        for (int i = 0; i < body->node_count(); ++i)
            if (body->mesh.nodes(2, i) < 1e-9) nodes.push_back(i);
        lower = faces_of_nodes(*body, nodes);
    }
};
const DistanceField ground = plane_distance(Vector3d::Zero(), 2.0 * Vector3d::UnitZ());
constexpr ContactLaw rubbing{2e7, 1e-3, 0.4, 0.02, 1e-4, 0.0};  // Pa/m, m, -, m/s, m

TEST(ContactForce, PressesByTheDepthAlone) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
        const Brick brick(kind);
        ContactLaw smooth = rubbing;
        smooth.friction = 0.0;
        const ForceElementPointer element = contact(*brick.body, brick.lower, ground, smooth);
        for (const double depth : {-1.0, -1e-9, 0.0, 1e-6, 5e-4, 1e-3, 3e-3}) {
            const Matrix3Xd x = test::moved_by(*brick.body, {0.4, -0.2, -depth});
            const InternalEnergy out = test::force_of(*element, *brick.body, {x}, HessianKind::exact);
            const OneSided pressed = one_sided(depth, 1e-3);
            const double k = 2e7 * brick.area_m2;
            EXPECT_LT((test::resultant(out) - k * pressed.slope * Vector3d::UnitZ()).norm(), 1e-9) << depth;
            EXPECT_NEAR(out.energy, k * pressed.value, 1e-11) << depth;
            EXPECT_NEAR(test::stiffness_along(out, *brick.body, Vector3d::UnitZ()), k * pressed.second, 1e-7) << depth;
            EXPECT_NEAR(test::stiffness_along(out, *brick.body, Vector3d::UnitX()), 0.0, 1e-9);
            EXPECT_NEAR(deepest_penetration(*brick.body, brick.lower, ground, x), std::max(0.0, depth), 1e-15);
        }
        EXPECT_TRUE(element->parameters().empty());
        EXPECT_TRUE(element->has_potential());
        EXPECT_TRUE(element->depends_on_velocity());
    }
}

TEST(ContactForce, RubsWithinCoulombsLimitAgainstTheSliding) {
    const Brick brick(fem::ElementKind::hex8);
    const ForceElementPointer element = contact(*brick.body, brick.lower, ground, rubbing);
    const double depth = 2e-3, normal_N = 2e7 * brick.area_m2 * (depth - 0.5e-3);
    const Matrix3Xd x = test::moved_by(*brick.body, {0.0, 0.0, -depth});
    const Vector3d along(0.6, -0.8, 0.0);
    for (const double speed : {0.0, 1e-4, 0.02, 0.5, 1e3}) {
        const Matrix3Xd v = (speed * along + 7.0 * Vector3d::UnitZ()).replicate(1, x.cols());
        const Vector3d force = test::resultant(test::force_of(*element, *brick.body, {x, &v, 100.0, 1.0}));
        EXPECT_NEAR(force.z(), normal_N, 1e-8) << "the speed presses nothing";
        EXPECT_LT((force - normal_N * (Vector3d::UnitZ() - 0.4 * speed / std::hypot(speed, 0.02) * along)).norm(), 1e-8)
            << speed;
    }
    EXPECT_FALSE(element->has_potential());
    ASSERT_EQ(element->parameters().size(), 1u);
    EXPECT_EQ(element->parameters()[0].value, 0.4);
    // Twice the coefficient rubs twice as much.
    const Matrix3Xd v = along.replicate(1, x.cols());
    const ForceElementPointer rough = element->changed(VectorXd::Constant(1, 0.8));
    const Vector3d once = test::resultant(test::force_of(*element, *brick.body, {x, &v, 100.0, 1.0})),
                   twice = test::resultant(test::force_of(*rough, *brick.body, {x, &v, 100.0, 1.0}));
    EXPECT_LT((twice.head<2>() - 2.0 * once.head<2>()).norm(), 1e-9);
    EXPECT_NEAR(twice.z(), once.z(), 1e-9);
}

/// In statics the way from the rest shape stands for the sliding, and weak springs hold what nothing holds.
TEST(ContactForce, SticksInStaticsByTheDisplacement) {
    const Brick brick(fem::ElementKind::hex8);
    const double depth = 2e-3, normal_N = 2e7 * brick.area_m2 * (depth - 0.5e-3);
    ContactLaw bedded = rubbing;
    bedded.static_bed_Pa_m = 1e4;
    const ForceElementPointer element = contact(*brick.body, brick.lower, ground, rubbing),
                              held = contact(*brick.body, brick.lower, ground, bedded);
    for (const double slip : {0.0, 1e-5, 1e-4, 1e-3}) {
        const Matrix3Xd x = test::moved_by(*brick.body, {slip, 0.0, -depth});
        const Vector3d force = test::resultant(test::force_of(*element, *brick.body, {x}));
        EXPECT_NEAR(force.x(), -0.4 * normal_N * slip / std::hypot(slip, 1e-4), 1e-9) << slip;
        const Vector3d more = test::resultant(test::force_of(*held, *brick.body, {x})) - force;
        EXPECT_LT((more + 1e4 * brick.area_m2 * Vector3d(slip, 0.0, -depth)).norm(), 1e-9);
        const Matrix3Xd v = Matrix3Xd::Zero(3, x.cols());
        EXPECT_NEAR(test::resultant(test::force_of(*held, *brick.body, {x, &v, 100.0, 1.0})).x(), 0.0, 1e-12)
            << "in motion there is neither";
    }
    // The springs act where nothing touches, too.
    const Matrix3Xd above = test::moved_by(*brick.body, {0.0, 0.0, 0.01});
    EXPECT_NEAR(test::resultant(test::force_of(*held, *brick.body, {above})).z(), -1e4 * brick.area_m2 * 0.01, 1e-12);
    EXPECT_NEAR(test::force_of(*held, *brick.body, {above}).energy, 0.5e4 * brick.area_m2 * 1e-4, 1e-15);
}

/// The obstacle's curvature softens; it is in the exact Hessian and in no other.
TEST(ContactForce, LeavesTheCurvatureOutWhereTheHessianMustBePositive) {
    const Brick brick(fem::ElementKind::hex8);
    ContactLaw smooth = rubbing;
    smooth.friction = 0.0;
    const DistanceField ball = sphere_distance({0.03, 0.015, -0.047}, 0.05);
    const ForceElementPointer element = contact(*brick.body, brick.lower, ball, smooth);
    const Matrix3Xd& x = brick.body->mesh.nodes;
    const auto along_x = [&](HessianKind kind) {
        return test::stiffness_along(test::force_of(*element, *brick.body, {x}, kind), *brick.body, Vector3d::UnitX());
    };
    const double d = 1e-6;
    const auto pull = [&](double by) {
        const Matrix3Xd at = test::moved_by(*brick.body, {by, 0.0, 0.0});
        return test::force_of(*element, *brick.body, {at}).gradient.row(0).sum();
    };
    const double difference = (pull(d) - pull(-d)) / (2.0 * d);
    EXPECT_NEAR(along_x(HessianKind::exact), difference, 1e-5 * std::abs(along_x(HessianKind::positive)));
    EXPECT_GE(along_x(HessianKind::positive), 0.0);
    EXPECT_LT(along_x(HessianKind::exact), along_x(HessianKind::positive));
}

}  // namespace
}  // namespace myo::model::contact_tests
