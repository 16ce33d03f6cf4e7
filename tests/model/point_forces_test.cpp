#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "model/force_of.hpp"
#include "model/point_friction.hpp"
#include "model/point_pull.hpp"
#include "model/point_stop.hpp"
#include "model/tied_spring.hpp"
#include "support/beam.hpp"
#include "support/meshes.hpp"

namespace myo::model::point_forces_tests {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::force_of;
using test::moved_by;
using test::resultant;

/// A body that nothing holds, and a point of its last cell between four nodes of unequal shares.
struct Pointed {
    BodyPointer body;
    int cell = 3;
    std::vector<int> nodes;
    VectorXd shares = Eigen::Vector4d(0.1, 0.2, 0.3, 0.4);
    Vector3d point;

    Pointed() {
        test::BeamSpec spec;
        spec.clamped = false;
        body = test::make_beam(spec).body;
        for (const int corner : {1, 2, 5, 6}) nodes.push_back(body->mesh.cells(corner, cell));
        point = body->mesh.nodes(Eigen::all, nodes) * shares;
    }
    /// Expects a gradient that the nodes of the point carry by their shares, and no other.
    void expect_shared(const Matrix3Xd& gradient) const {
        Matrix3Xd rest = gradient;
        const Vector3d total = gradient.rowwise().sum();
        for (std::size_t a = 0; a < nodes.size(); ++a)
            rest.col(nodes[a]) -= shares(static_cast<Eigen::Index>(a)) * total;
        EXPECT_LT(rest.norm(), 1e-13 * total.norm());
    }
};

TEST(TiedSpring, PullsWhatMovesAwayAndPushesWhatComesNear) {
    const Pointed p;
    const Vector3d d = Vector3d(2.0, -1.0, 0.5).normalized();
    const double k = 40.0;
    const ForceElementPointer spring = tied_spring(*p.body, p.cell, p.nodes, p.shares, p.point + 0.05 * d, k);
    for (const double away : {0.0, 1e-6, 0.02, 0.3, -1e-6, -0.02, -0.049}) {
        const Matrix3Xd x = moved_by(*p.body, -away * d);
        const InternalEnergy out = force_of(*spring, *p.body, {x});
        EXPECT_NEAR(out.energy, 0.5 * k * away * away, 1e-14) << away;
        EXPECT_LT((resultant(out) - k * away * d).norm(), 1e-12) << away;
        if (away != 0.0) p.expect_shared(out.gradient);
    }
    // Sideways the spring is longer, and pulls along itself.
    const Vector3d across = d.unitOrthogonal();
    const Matrix3Xd x = moved_by(*p.body, 0.12 * across);  // 5, 12, 13
    const InternalEnergy out = force_of(*spring, *p.body, {x});
    EXPECT_NEAR(out.energy, 0.5 * k * 0.08 * 0.08, 1e-14);
    EXPECT_LT((resultant(out) - k * 0.08 * (5.0 * d - 12.0 * across) / 13.0).norm(), 1e-13);
}

TEST(TiedSpring, HasTheStiffnessOfItsEnergyAndNoNegativeOneWhereNoneIsAllowed) {
    const Pointed p;
    const Vector3d d = Vector3d(1.0, 1.0, -3.0).normalized(), across = d.unitOrthogonal();
    const double k = 40.0;
    const ForceElementPointer spring = tied_spring(*p.body, p.cell, p.nodes, p.shares, p.point + 0.05 * d, k);
    for (const double away : {0.01, -0.01}) {
        const Matrix3Xd x = moved_by(*p.body, -away * d);
        const auto stiffness = [&](HessianKind kind, const Vector3d& along) {
            return test::stiffness_along(force_of(*spring, *p.body, {x}, kind), *p.body, along);
        };
        const double geometric = k * away / (0.05 + away);
        EXPECT_NEAR(stiffness(HessianKind::exact, d), k, 1e-11);
        EXPECT_NEAR(stiffness(HessianKind::exact, across), geometric, 1e-11);
        EXPECT_NEAR(stiffness(HessianKind::positive, d), k, 1e-11);
        EXPECT_NEAR(stiffness(HessianKind::positive, across), std::max(0.0, geometric), 1e-11);
        // Rough motions: the Hessian is the derivative of the gradient.
        const Matrix3Xd motion = test::rough_field(x.cols(), 0.4);
        const Matrix3Xd up = x + 1e-6 * motion, down = x - 1e-6 * motion;
        const Matrix3Xd difference = (force_of(*spring, *p.body, {up}).gradient -
                                      force_of(*spring, *p.body, {down}).gradient) /
                                     2e-6;
        const InternalEnergy out = force_of(*spring, *p.body, {x}, HessianKind::exact);
        const VectorXd product = out.hessian.selfadjointView<Eigen::Lower>() * gather(p.body->pattern, motion);
        EXPECT_GT(difference.norm(), 0.1);
        EXPECT_LT((product - gather(p.body->pattern, difference)).norm(), 1e-7 * difference.norm());
    }
}

/// The force is proportional to the only parameter; a spring of none has a scale for its changes all the same.
TEST(TiedSpring, IsLinearInItsStiffness) {
    const Pointed p;
    const Vector3d anchor = p.point + Vector3d(0.0, 0.0, 0.1);
    const Matrix3Xd x = p.body->mesh.nodes + 1e-3 * test::rough_field(p.body->node_count(), 0.9);
    const ForceElementPointer spring = tied_spring(*p.body, p.cell, p.nodes, p.shares, anchor, 7.0);
    Matrix3Xd tangent = Matrix3Xd::Zero(3, x.cols());
    spring->add_tangent(*p.body, {x}, VectorXd::Constant(1, 2.0), tangent);
    const Matrix3Xd gradient = force_of(*spring, *p.body, {x}).gradient;
    EXPECT_GT(gradient.norm(), 0.0);
    EXPECT_LT((3.5 * tangent - gradient).norm(), 1e-13 * gradient.norm());
    const Matrix3Xd doubled = force_of(*spring->changed(VectorXd::Constant(1, 14.0)), *p.body, {x}).gradient;
    EXPECT_LT((doubled - 2.0 * gradient).norm(), 1e-13 * gradient.norm());
    EXPECT_EQ(spring->parameters().at(0).scale, 7.0);
    EXPECT_EQ(tied_spring(*p.body, p.cell, p.nodes, p.shares, anchor, 0.0)->parameters().at(0).scale, 1.0);
}

TEST(PointPull, DrawsEveryNodeToItsOwnPlace) {
    const Pointed p;
    const double k = 30.0;
    const Matrix3Xd X = p.body->mesh.nodes(Eigen::all, p.nodes), places = X + 0.01 * test::rough_field(4, 0.2);
    const ForceElementPointer pull = point_pull(*p.body, p.nodes, p.shares, places, k);
    Matrix3Xd x = p.body->mesh.nodes;
    const InternalEnergy out = force_of(*pull, *p.body, {x});
    double energy = 0.0;
    for (Eigen::Index i = 0; i < 4; ++i) {
        energy += 0.5 * k * p.shares(i) * (X.col(i) - places.col(i)).squaredNorm();
        EXPECT_LT(
            (out.gradient.col(p.nodes[static_cast<std::size_t>(i)]) - k * p.shares(i) * (X.col(i) - places.col(i)))
                .norm(),
            1e-14);
    }
    EXPECT_NEAR(out.energy, energy, 1e-15);
    x(Eigen::all, p.nodes) = places;
    EXPECT_EQ(force_of(*pull, *p.body, {x}).energy, 0.0);
    EXPECT_EQ(force_of(*pull, *p.body, {x}).gradient.norm(), 0.0);
}

/// Nothing before half an onset short of the gap, a spring from the gap on beyond half an onset, and an eighth of the
/// onset times the stiffness at the gap itself.
TEST(PointStop, PushesBackFromItsGapOn) {
    const Pointed p;
    const double k = 200.0, gap = 5e-3, onset = 1e-3;
    struct Move {
        double by, force_N;
    };
    for (const double length : {1.0, 25.0}) {  // of the normal
        const Vector3d normal = Vector3d(0.0, 0.6, 0.8);
        const ForceElementPointer stop = point_stop(*p.body, p.cell, p.nodes, p.shares, length * normal, gap, k, onset);
        for (const Move& move : {Move{-1.0, 0.0},
                                 {0.0, 0.0},
                                 {4e-3, 0.0},
                                 {4.499e-3, 0.0},
                                 {5e-3, 200.0 * 1.25e-4},
                                 {5.5e-3, 0.1},
                                 {5.501e-3, 0.1002},
                                 {9e-3, 0.8},
                                 {0.105, 20.0}}) {
            // Along the stop's surface the point moves freely.
            const Matrix3Xd x = moved_by(*p.body, -move.by * normal + 0.3 * normal.unitOrthogonal());
            const InternalEnergy out = force_of(*stop, *p.body, {x});
            EXPECT_LT((resultant(out) - move.force_N * normal).norm(), 1e-12) << move.by;
            EXPECT_EQ(out.energy > 0.0, move.force_N > 0.0) << move.by;
            if (move.force_N > 0.0) p.expect_shared(out.gradient);
        }
    }
}

TEST(PointStop, GivesWayToAWiderGapByItsStiffness) {
    const Pointed p;
    const double k = 200.0, gap = 5e-3, onset = 1e-3;
    const ForceElementPointer stop = point_stop(*p.body, p.cell, p.nodes, p.shares, Vector3d::UnitZ(), gap, k, onset);
    const auto push_by_gap = [&](double by) {
        const Matrix3Xd x = moved_by(*p.body, {0.0, 0.0, -by});
        Matrix3Xd gradient = Matrix3Xd::Zero(3, x.cols());
        stop->add_tangent(*p.body, {x}, Eigen::Vector2d(0.0, 1.0), gradient);
        return -gradient.row(2).sum();
    };
    EXPECT_EQ(push_by_gap(4e-3), 0.0);
    EXPECT_NEAR(push_by_gap(5e-3), -0.5 * k, 1e-9) << "half of the stiffness at the gap";
    EXPECT_NEAR(push_by_gap(8e-3), -k, 1e-9);
    ASSERT_EQ(stop->parameters().size(), 2u);
    EXPECT_EQ(stop->parameters()[0].name, "stiffness_N_m");
    EXPECT_EQ(parameter_values(*stop), VectorXd(Eigen::Vector2d(k, gap)));
}

TEST(PointFriction, ApproachesItsForceWithTheSpeedAcrossTheNormal) {
    const Pointed p;
    const double force_N = 0.3, v0 = 0.02;
    const Vector3d normal = Vector3d(0.0, 0.0, 4.0), along = Vector3d(0.6, 0.8, 0.0);
    const auto friction = [&](const std::optional<Vector3d>& across, const Vector3d& velocity, double time_s) {
        const Matrix3Xd x = p.body->mesh.nodes, v = velocity.replicate(1, x.cols());
        const ForceElementPointer element = point_friction(*p.body, p.cell, p.nodes, p.shares, across, force_N, v0);
        return resultant(force_of(*element, *p.body, {x, &v, 0.0, time_s}));
    };
    for (const double speed : {0.0, 1e-3 * v0, v0, 3.0 * v0, 1e4 * v0}) {
        const Vector3d expected = -force_N * speed / std::hypot(speed, v0) * along;
        // What goes along the normal rubs nothing.
        EXPECT_LT((friction(normal, speed * along + 5.0 * Vector3d::UnitZ(), 1.0) - expected).norm(), 1e-14) << speed;
        EXPECT_LT((friction(std::nullopt, speed * along, 1.0) - expected).norm(), 1e-14) << speed;
    }
    EXPECT_NEAR(friction(std::nullopt, 1e4 * v0 * Vector3d::UnitZ(), 1.0).z(), -force_N, 1e-8);
    EXPECT_EQ(friction(normal, along, -1e-9).norm(), 0.0) << "before the start";
    EXPECT_GT(friction(normal, along, 0.0).norm(), 0.0);
}

TEST(PointFriction, BeginsAtTheStart) {
    const Pointed p;
    const ForceElementPointer element = point_friction(*p.body, p.cell, p.nodes, p.shares, std::nullopt, 0.3, 0.02);
    const Matrix3Xd x = p.body->mesh.nodes, v = Vector3d(0.1, 0.0, 0.0).replicate(1, x.cols());
    EXPECT_EQ(force_of(*element, *p.body, {x, nullptr, 100.0, 1.0}).gradient.norm(), 0.0) << "statics";
    EXPECT_EQ(force_of(*element, *p.body, {x, &v, 100.0, 0.0, true}).gradient.norm(), 0.0);
    EXPECT_GT(force_of(*element, *p.body, {x, &v, 100.0, 0.0, false}).gradient.norm(), 0.0);
    EXPECT_EQ(element->jumps(), std::vector<double>{0.0});
    EXPECT_TRUE(element->steady(-2.0, -1.0));
    EXPECT_FALSE(element->steady(-1.0, 1.0));
    EXPECT_TRUE(element->steady(0.0, 1.0));
    // The potential of a step is the dissipation over dv/dx; without dv/dx there is none.
    EXPECT_NEAR(force_of(*element, *p.body, {x, &v, 100.0, 1.0}).energy, 0.3 / 100.0 * std::hypot(0.1, 0.02), 1e-15);
    EXPECT_EQ(force_of(*element, *p.body, {x, &v, 0.0, 1.0}).energy, 0.0);
}

}  // namespace
}  // namespace myo::model::point_forces_tests
