#include "model/mount_forces.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "model/directional_mass.hpp"
#include "model/force_of.hpp"
#include "model/mount_motion.hpp"
#include "model/tied_spring.hpp"
#include "support/beam.hpp"
#include "support/turning_mount.hpp"

namespace myo::model::mount_forces_tests {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A mount that stands in one pose for ever, whatever its velocities.
struct Posed : MountMotion {
    MountPose pose;
    bool is_turning = true;
    MountPose at(double) const override { return pose; }
    bool turns() const override { return is_turning; }
};
std::shared_ptr<Posed> posed() {
    auto mount = std::make_shared<Posed>();
    mount->pose.rotation = Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
    mount->pose.pivot_m = {0.02, 0.0, 0.01};
    return mount;
}

/// A brick of 0.1 x 0.03 x 0.03 m and a body of 40 g at its end.
struct Loaded {
    test::BeamSpec spec;
    Model model;
    double brick_kg, kg;
    Vector3d centre_m;  // of both

    Loaded() {
        spec.clamped = false;
        model = test::make_beam(spec);
        model.masses.push_back({test::tip_share(model, spec), 0.04});
        brick_kg = spec.density_kg_m3 * spec.size.prod();
        kg = brick_kg + 0.04;
        centre_m = (brick_kg * 0.5 * spec.size + 0.04 * Vector3d(0.1, 0.015, 0.015)) / kg;
    }
    Vector3d force(const MountMotionPointer& mount, const Matrix3Xd* v, double time_s = 0.0) const {
        const Matrix3Xd x = model.body->mesh.nodes;
        return test::resultant(test::force_of(*mount_forces(model, mount), *model.body, {x, v, 0.0, time_s}));
    }
    Matrix3Xd still() const { return Matrix3Xd::Zero(3, model.body->node_count()); }
};

TEST(MountForces, TurnWeightAndLoadsIntoTheFrameOfTheMount) {
    Loaded body;
    body.model.gravity_m_s2 = {0.5, 0.0, -9.0};
    DeadForce load;
    load.share = test::tip_share(body.model, body.spec);
    load.force_N = {1.0, 2.0, -3.0};
    load.from_s = 1.0;
    load.until_s = 2.0;
    body.model.forces = {load};
    const auto mount = posed();
    const Matrix3d back = mount->pose.rotation.transpose();
    for (const double t : {0.5, 1.0, 1.5, 2.0}) {
        // With the weight as it stands in the model the sum is the weight as the mount sees it.
        const Vector3d there = body.kg * body.model.gravity_m_s2 + load.factor(t, false) * load.force_N;
        EXPECT_LT((body.force(mount, nullptr, t) + there - back * there).norm(), 1e-12) << t;
        // A mount at rest has no inertia forces, with velocities or without.
        const Matrix3Xd v = Vector3d(1.0, 2.0, 3.0).replicate(1, body.model.body->node_count());
        EXPECT_LT((body.force(mount, &v, t) + there - back * there).norm(), 1e-12) << t;
    }
    EXPECT_EQ(Loaded().force(mount, nullptr).norm(), 0.0) << "neither weight nor loads";
}

TEST(MountForces, AreMassTimesTheAccelerationOfTheFrame) {
    const Loaded body;
    const Matrix3Xd still = body.still();
    const auto mount = posed();
    const Vector3d a(1.0, -2.0, 5.0), spin(0.0, 3.0, -4.0), rate(7.0, 1.0, 2.0), V(0.3, 0.6, -0.2);
    const Matrix3Xd v = V.replicate(1, still.cols());
    const Vector3d r = body.centre_m - mount->pose.pivot_m;
    mount->pose.velocity_m_s = {100.0, 200.0, 300.0};  // an even motion is not felt
    EXPECT_LT(body.force(mount, &still).norm(), 1e-12);
    mount->pose.acceleration_m_s2 = a;
    EXPECT_LT((body.force(mount, &still) + body.kg * mount->pose.rotation.transpose() * a).norm(), 1e-12);
    mount->pose.acceleration_m_s2.setZero();
    mount->pose.spin_rad_s = spin;
    EXPECT_LT((body.force(mount, &still) + body.kg * spin.cross(spin.cross(r))).norm(), 1e-12) << "centrifugal";
    EXPECT_GT(body.force(mount, &still).dot(r), 0.0) << "away from the axis";
    EXPECT_LT((body.force(mount, &v) - body.force(mount, &still) + 2.0 * body.kg * spin.cross(V)).norm(), 1e-12)
        << "Coriolis";
    mount->pose.spin_rad_s.setZero();
    mount->pose.spin_rate_rad_s2 = rate;
    EXPECT_LT((body.force(mount, &still) + body.kg * rate.cross(r)).norm(), 1e-12) << "Euler";
    EXPECT_EQ(body.force(mount, nullptr).norm(), 0.0) << "none in statics";
}

TEST(MountForces, FollowTheMassesOfTheirTime) {
    Loaded body;
    body.model.directional_masses = {line_mass(test::tip_share(body.model, body.spec), Vector3d::UnitX(), 2.0)};
    body.model.directional_masses[0].until_s = 1.0;
    const auto mount = posed();
    mount->pose.rotation.setIdentity();
    mount->pose.acceleration_m_s2 = {3.0, 5.0, 0.0};
    const Matrix3Xd still = body.still(), x = body.model.body->mesh.nodes;
    EXPECT_LT((body.force(mount, &still, 0.5) + Vector3d(3.0 * (body.kg + 2.0), 5.0 * body.kg, 0.0)).norm(), 1e-12);
    EXPECT_LT((body.force(mount, &still, 1.0) + body.kg * Vector3d(3.0, 5.0, 0.0)).norm(), 1e-12);
    const ForceElementPointer element = mount_forces(body.model, mount);
    EXPECT_NEAR(test::resultant(test::force_of(*element, *body.model.body, {x, &still, 0.0, 1.0, true})).x(),
                -3.0 * (body.kg + 2.0), 1e-12)
        << "up to its end";
    // The density is that of the brick alone.
    const ForceElementPointer denser = element->changed(VectorXd::Constant(1, 2.0 * body.spec.density_kg_m3));
    EXPECT_NEAR(test::resultant(test::force_of(*denser, *body.model.body, {x, &still, 0.0, 0.5})).y(),
                -5.0 * (body.kg + body.brick_kg), 1e-12);
    EXPECT_EQ(parameter_values(*denser)(0), 2.0 * body.spec.density_kg_m3);
    EXPECT_FALSE(element->steady(0.0, 1.0));
}

TEST(MountForces, HaveAPotentialUnlessTheMountTurns) {
    const Loaded body;
    const auto mount = posed();
    EXPECT_FALSE(mount_forces(body.model, mount)->has_potential());
    mount->is_turning = false;
    EXPECT_TRUE(mount_forces(body.model, mount)->has_potential());
    EXPECT_TRUE(mount_forces(body.model, mount)->depends_on_velocity());
}

/// A spring to an anchor in the laboratory pulls a body on the mount as its place in the laboratory says.
TEST(InLaboratory, TurnsForcesAndStiffnessIntoTheFrameOfTheMount) {
    const Loaded body;
    const Body& brick = *body.model.body;
    const auto mount = posed();
    mount->pose.place_m = {0.5, -0.3, 0.2};
    const auto column = brick.mesh.cells.col(0);
    const std::vector<int> nodes(column.begin(), column.end());
    const Vector3d anchor(0.4, 0.1, 0.6);
    const ForceElementPointer spring = tied_spring(brick, 0, nodes, VectorXd::Constant(8, 0.125), anchor, 50.0),
                              seen = in_laboratory(spring, mount);
    const Matrix3Xd x = brick.mesh.nodes, there = mount->pose.in_laboratory(x);
    const InternalEnergy in_lab = test::force_of(*spring, brick, {there}, HessianKind::exact),
                         on_mount = test::force_of(*seen, brick, {x}, HessianKind::exact);
    EXPECT_GT(in_lab.energy, 0.0);
    EXPECT_EQ(on_mount.energy, in_lab.energy);
    const Matrix3d& R = mount->pose.rotation;
    EXPECT_LT((R * test::resultant(on_mount) - test::resultant(in_lab)).norm(), 1e-12);
    for (const Vector3d& d : {Vector3d(1.0, 0.0, 0.0), Vector3d(0.6, 0.0, 0.8), Vector3d(0.48, -0.6, 0.64)})
        EXPECT_NEAR(test::stiffness_along(on_mount, brick, d), test::stiffness_along(in_lab, brick, R * d), 1e-10);
    EXPECT_EQ(parameter_values(*seen), parameter_values(*spring));
    EXPECT_TRUE(seen->has_potential()) << "no velocity enters";
    EXPECT_FALSE(seen->steady(0.0, 1.0));
    Matrix3Xd tangent = Matrix3Xd::Zero(3, x.cols());
    seen->add_tangent(brick, {x}, VectorXd::Constant(1, 50.0), tangent);
    EXPECT_LT((tangent - on_mount.gradient).norm(), 1e-12) << "linear in the stiffness";
}

TEST(MountMotion, WithoutVibrationOrClockIsItself) {
    const MountMotionPointer tumbling = test::tumbling_mount();
    EXPECT_EQ(with_vibrations(tumbling, {}), tumbling);
    EXPECT_EQ(with_vibrations(nullptr, {}), nullptr);
    EXPECT_EQ(by_clock(tumbling, 0.0, 1.0), tumbling);
    EXPECT_EQ(by_clock(nullptr, 0.3, 1.1), nullptr);
    EXPECT_NE(by_clock(tumbling, 0.3, 1.0), tumbling);
    EXPECT_NE(by_clock(tumbling, 0.0, 1.1), tumbling);
    EXPECT_TRUE(by_clock(tumbling, 0.3, 1.0)->turns());
    EXPECT_TRUE(with_vibrations(tumbling, {MountVibration{}})->turns());
    EXPECT_FALSE(with_vibrations(nullptr, {MountVibration{}})->turns());
}

TEST(MountMotion, VibratesBySinesThatAdd) {
    const double pi = std::numbers::pi;
    const MountMotionPointer shaken = with_vibrations(
        nullptr, {{{1e-3, 0.0, 0.0}, 2.0, 0.0}, {{0.0, 3e-3, 0.0}, 0.5, pi / 2.0}, {{0.0, 0.0, 7e-3}, 0.0, pi / 2.0}});
    // At an eighth of a second: a quarter turn of the first, a sixteenth of the second; the third stands still.
    const MountPose pose = shaken->at(0.125);
    const double w = 4.0 * pi, slow = pi, c = std::cos(pi / 8.0), s = std::sin(pi / 8.0);
    EXPECT_LT((pose.place_m - Vector3d(1e-3, 3e-3 * c, 7e-3)).norm(), 1e-16);
    EXPECT_LT((pose.velocity_m_s - Vector3d(0.0, -3e-3 * slow * s, 0.0)).norm(), 1e-16);
    EXPECT_LT((pose.acceleration_m_s2 - Vector3d(-1e-3 * w * w, -3e-3 * slow * slow * c, 0.0)).norm(), 1e-15);
    EXPECT_EQ(pose.rotation, Matrix3d(Matrix3d::Identity()));
    // Vibrations are added to a motion, along directions of the laboratory.
    const auto tumbling = test::tumbling_mount();
    const MountPose both = with_vibrations(tumbling, {{{1e-3, 0.0, 0.0}, 2.0, 0.0}})->at(0.125);
    EXPECT_LT((both.place_m - tumbling->at(0.125).place_m - Vector3d(1e-3, 0.0, 0.0)).norm(), 1e-15);
    EXPECT_EQ(both.spin_rad_s, tumbling->at(0.125).spin_rad_s);
}

/// A clock that runs at another rate shows the same places at other times.
TEST(MountMotion, IsReadByItsClock) {
    const auto tumbling = test::tumbling_mount();
    const MountPose late = by_clock(tumbling, 0.2, 1.5)->at(0.6), own = tumbling->at(1.5 * (0.6 - 0.2));
    EXPECT_EQ(late.place_m, own.place_m);
    EXPECT_EQ(late.rotation, own.rotation);
    EXPECT_EQ(late.pivot_m, own.pivot_m);
    EXPECT_LT((late.velocity_m_s - 1.5 * own.velocity_m_s).norm(), 1e-15);
    EXPECT_LT((late.spin_rad_s - 1.5 * own.spin_rad_s).norm(), 1e-14);
    EXPECT_LT((late.acceleration_m_s2 - 2.25 * own.acceleration_m_s2).norm(), 1e-14);
    EXPECT_LT((late.spin_rate_rad_s2 - 2.25 * own.spin_rate_rad_s2).norm(), 1e-12);
}

}  // namespace
}  // namespace myo::model::mount_forces_tests
