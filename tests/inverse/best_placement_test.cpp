#include "inverse/best_placement.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>

#include "measurement/rigid_motion.hpp"
#include "support/beam.hpp"
#include "support/differences.hpp"
#include "support/not_finite.hpp"

namespace myo::inverse::best_placement_test {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Four markers on a beam that moves by hand for 0.2 s, as cameras see it that stand elsewhere.
struct Seen {
    model::Model model = test::make_beam({});
    MarkerTarget target;
    sensitivity::NodeMotion motion;

    explicit Seen(const MarkerPlacement& truth) {
        const mesh::VolumeMesh& mesh = model.body->mesh;
        target.markers = measurement::marker_set(
            mesh, {{0.1, 0.01, 0.03}, {0.05, 0.03, 0.02}, {0.02, 0.0, 0.01}, {0.08, 0.02, 0.0}});
        for (int k = 0; k <= 4; ++k) {
            Matrix3Xd x = mesh.nodes(Eigen::all, target.markers.nodes);
            x.row(2).array() += 0.002 * k * x.row(0).array() / 0.1;
            motion.times_s.push_back(0.05 * k);
            motion.positions.push_back(x);
            motion.velocities.emplace_back(Matrix3Xd::Zero(3, x.cols()));
        }
        target.times_s = VectorXd::LinSpaced(5, 0.0, 0.2);
        const Eigen::Matrix3d R = measurement::small_rotation(truth.rotation_rad);
        for (const Matrix3Xd& track : measurement::observe(motion, target.markers, target.times_s).positions)
            target.positions_m.emplace_back((R * track).colwise() + truth.translation_m);
    }
};

TEST(BestPlacement, IsHowTheCamerasStand) {
    const MarkerPlacement truth{{2e-3, -1e-3, 3e-3}, {0.04, -0.02, 0.06}, 0.0};
    Seen seen(truth);
    // Occluded samples do not matter, nor where the search would otherwise begin.
    seen.target.positions_m[1].col(2).setConstant(test::nan);
    seen.target.placement.translation_m = {0.1, 0.1, 0.1};
    const MarkerPlacement found = best_placement(seen.target, seen.motion, {0.01, 0.2});
    EXPECT_LT((found.translation_m - truth.translation_m).norm(), 1e-9);
    EXPECT_LT((found.rotation_rad - truth.rotation_rad).norm(), 1e-8);
    EXPECT_FALSE(at_bound(found, {0.01, 0.2}));
    // Displacements do not show it: what was given stays.
    seen.target.from_start = true;
    EXPECT_EQ(best_placement(seen.target, seen.motion, {0.01, 0.2}).translation_m, Vector3d(0.1, 0.1, 0.1));
}

TEST(BestPlacement, EndsWhereTheLossWouldLeaveTheBounds) {
    const Seen seen({{5e-3, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0});
    const PlacementBounds bounds{3e-3, 0.05};
    MarkerTarget target = seen.target;
    target.placement = best_placement(target, seen.motion, bounds);
    EXPECT_NEAR(target.placement.translation_m.x(), 3e-3, 1e-12);
    EXPECT_TRUE(at_bound(target.placement, bounds));
    const MarkerPlacement slope = mean_square_by_placement(target, seen.motion);
    EXPECT_LT(slope.translation_m.x(), 0.0) << "further along x the loss falls";
    const double size = std::abs(slope.translation_m.x());
    EXPECT_LT(std::abs(slope.translation_m.y()), 1e-6 * size);
    EXPECT_LT(std::abs(slope.translation_m.z()), 1e-6 * size);
    EXPECT_LT(slope.rotation_rad.cwiseAbs().maxCoeff(), 1e-6 * size);
}

TEST(BestPlacement, LeavesAloneWhatHasNoRoom) {
    const MarkerPlacement truth{{2e-3, 0.0, 0.0}, {0.0, 0.0, 0.03}, 0.0};
    const Seen seen(truth);
    const MarkerPlacement shifted = best_placement(seen.target, seen.motion, {0.01, 0.0});
    EXPECT_EQ(shifted.rotation_rad, Vector3d(Vector3d::Zero()));
    EXPECT_GT(shifted.translation_m.norm(), 1e-4);
    const MarkerPlacement turned = best_placement(seen.target, seen.motion, {0.0, 0.1});
    EXPECT_EQ(turned.translation_m, Vector3d(Vector3d::Zero()));
    EXPECT_GT(turned.rotation_rad.norm(), 1e-3);
}

TEST(PlacementBound, IsReachedWithinRounding) {
    const PlacementBounds bounds{1e-3, 0.1};
    MarkerPlacement placement;
    EXPECT_FALSE(at_bound(placement, bounds));
    for (const double share : {0.999, 1.0 - 1e-12, 1.0}) {
        placement.translation_m = {0.0, -share * 1e-3, 0.0};
        EXPECT_EQ(at_bound(placement, bounds), share > 0.9999) << share;
        placement.translation_m.setZero();
        placement.rotation_rad = {0.0, 0.0, share * 0.1};
        EXPECT_EQ(at_bound(placement, bounds), share > 0.9999) << share;
        placement.rotation_rad.setZero();
    }
    EXPECT_FALSE(at_bound(placement, {1e-3, 0.0})) << "what has no room does not end at its bound";
    EXPECT_FALSE(at_bound(placement, {0.0, 0.0}));
}

TEST(PlacementTangents, AreDerivativesOfThePlacedMarker) {
    const Vector3d x(0.1, -0.02, 0.03);
    const auto placed = [&](const VectorXd& p) {
        return VectorXd(measurement::small_rotation(p.tail<3>()) * x + p.head<3>());
    };
    VectorXd at(6);
    at << 1e-3, 2e-3, -1e-3, 0.3, -0.2, 0.5;
    MarkerPlacement placement;
    placement.translation_m = at.head<3>();
    placement.rotation_rad = at.tail<3>();
    test::expect_derivative(placement_tangent(placement, x), test::central_differences(placed, at, 1e-5), 1e-8,
                            "placement");
}

}  // namespace
}  // namespace myo::inverse::best_placement_test
