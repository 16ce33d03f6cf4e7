#include "inverse/marker_target.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "measurement/rigid_motion.hpp"
#include "support/beam.hpp"

namespace myo::inverse {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Two markers on a beam that is moved by hand: a smooth motion in time. The last samples are after its end, where it
/// stays.
struct Moved {
    model::Model model = test::make_beam({});
    MarkerTarget target;
    sensitivity::NodeMotion motion;

    explicit Moved(bool from_start) {
        const mesh::VolumeMesh& mesh = model.body->mesh;
        target.markers = measurement::marker_set(mesh, {{0.1, 0.01, 0.03}, {0.05, 0.03, 0.02}});
        target.from_start = from_start;
        const double h = 0.01;
        for (int k = 0; k <= 20; ++k) {
            const double t = k * h;
            Matrix3Xd x = mesh.nodes(Eigen::all, target.markers.nodes), v = Matrix3Xd::Zero(3, x.cols());
            for (Eigen::Index i = 0; i < x.cols(); ++i) {
                const Vector3d amplitude = 0.004 * Vector3d(std::sin(40.0 * x(0, i)), std::cos(30.0 * x(1, i)), 1.0);
                x.col(i) += amplitude * std::sin(20.0 * t);
                v.col(i) = amplitude * 20.0 * std::cos(20.0 * t);
            }
            motion.times_s.push_back(t);
            motion.positions.push_back(x);
            motion.velocities.push_back(v);
        }
        target.times_s = VectorXd::LinSpaced(12, 0.013, 0.257);
        const measurement::MarkerTracks seen = measurement::observe(motion, target.markers, target.times_s);
        for (std::size_t m = 0; m < 2; ++m) {
            Matrix3Xd y = seen.positions[m] + 1e-3 * test::rough_field(12, static_cast<double>(m));
            y.col(4).setConstant(std::numeric_limits<double>::quiet_NaN());
            target.positions_m.push_back(y);
        }
        target.placement = {{1e-3, -2e-3, 5e-4}, {0.03, -0.02, 0.05}, 0.0021};
    }
};

class MarkerTargets : public testing::TestWithParam<bool> {};

TEST_P(MarkerTargets, KnowTheDerivativeByTheirPlacement) {
    const Moved given(GetParam());
    const MarkerPlacement gradient = mean_square_by_placement(given.target, given.motion);
    const auto difference = [&](double step, const auto& change) {
        const auto loss = [&](double by) {
            MarkerTarget target = given.target;
            change(target.placement, by);
            return mean_square(target, given.motion).value;
        };
        return (loss(step) - loss(-step)) / (2.0 * step);
    };
    for (Eigen::Index k = 0; k < 3; ++k) {
        const double turned = difference(1e-5, [k](MarkerPlacement& p, double by) { p.rotation_rad(k) += by; });
        EXPECT_NEAR(gradient.rotation_rad(k) / turned, 1.0, 1e-6);
        const double moved = difference(1e-6, [k](MarkerPlacement& p, double by) { p.translation_m(k) += by; });
        if (GetParam())
            EXPECT_EQ(gradient.translation_m(k), 0.0);
        else
            EXPECT_NEAR(gradient.translation_m(k) / moved, 1.0, 1e-6);
    }
    EXPECT_NEAR(gradient.start_shift_s / difference(1e-6, [](MarkerPlacement& p, double by) { p.start_shift_s += by; }),
                1.0, 1e-6);
}

TEST_P(MarkerTargets, KnowTheDerivativeByTheMotionAsPlaced) {
    const Moved given(GetParam());
    const sensitivity::MotionLoss loss = mean_square(given.target, given.motion);
    const std::size_t at = 6;
    const Matrix3Xd d = test::rough_field(given.motion.positions[at].cols(), 0.7);
    const auto moved = [&](double by) {
        sensitivity::NodeMotion motion = given.motion;
        motion.positions[at] += by * d;
        return mean_square(given.target, motion).value;
    };
    EXPECT_NEAR(loss.d_positions[at].cwiseProduct(d).sum() / ((moved(1e-6) - moved(-1e-6)) / 2e-6), 1.0, 1e-6);
}

/// Weights of single coordinates, 0 among them.
MarkerTarget weighted(MarkerTarget target) {
    for (std::size_t m = 0; m < target.positions_m.size(); ++m)
        target.weights.push_back(
            (2.0 + test::rough_field(target.times_s.size(), 3.0 + static_cast<double>(m)).array()).matrix());
    target.weights[0].row(1).setZero();
    target.positions_m[1](2, 7) = std::numeric_limits<double>::quiet_NaN();
    return target;
}

TEST_P(MarkerTargets, CountCoordinatesByTheirWeights) {
    const Moved given(GetParam());
    const MarkerTarget target = weighted(given.target);
    const std::vector<Matrix3Xd> residuals = target_residuals(target, given.motion);
    double sum = 0.0, weights = 0.0;
    for (std::size_t m = 0; m < residuals.size(); ++m)
        for (Eigen::Index k = 0; k < residuals[m].size(); ++k) {
            if (!std::isfinite(residuals[m](k))) continue;
            sum += target.weights[m](k) * residuals[m](k) * residuals[m](k);
            weights += target.weights[m](k);
        }
    const sensitivity::MotionLoss loss = mean_square(target, given.motion);
    EXPECT_NEAR(loss.value, sum / weights, 1e-12 * loss.value);
    const std::size_t at = 6;
    const Matrix3Xd d = test::rough_field(given.motion.positions[at].cols(), 0.7);
    const auto moved = [&](double by) {
        sensitivity::NodeMotion motion = given.motion;
        motion.positions[at] += by * d;
        return mean_square(target, motion).value;
    };
    EXPECT_NEAR(loss.d_positions[at].cwiseProduct(d).sum() / ((moved(1e-6) - moved(-1e-6)) / 2e-6), 1.0, 1e-6);
    const MarkerPlacement gradient = mean_square_by_placement(target, given.motion);
    const auto turned = [&](double by) {
        MarkerTarget changed = target;
        changed.placement.rotation_rad.y() += by;
        return mean_square(changed, given.motion).value;
    };
    EXPECT_NEAR(gradient.rotation_rad.y() / ((turned(1e-5) - turned(-1e-5)) / 2e-5), 1.0, 1e-6);
}

/// A target made by the placed motion itself is met exactly.
TEST_P(MarkerTargets, AreMetByWhatThePlacementSays) {
    Moved given(GetParam());
    MarkerTarget& target = given.target;
    const Eigen::Matrix3d R = measurement::small_rotation(target.placement.rotation_rad);
    const VectorXd times = target.times_s.array() - target.placement.start_shift_s;
    const measurement::MarkerTracks seen = measurement::observe(given.motion, target.markers, times),
                                    origin = measurement::observe(given.motion, target.markers, VectorXd::Zero(1));
    for (std::size_t m = 0; m < 2; ++m) {
        if (target.from_start)
            target.positions_m[m] = R * (seen.positions[m].colwise() - Vector3d(origin.positions[m].col(0)));
        else
            target.positions_m[m] = (R * seen.positions[m]).colwise() + target.placement.translation_m;
    }
    EXPECT_LT(mean_square(target, given.motion).value, 1e-30);
}

/// Of a run with tangents they are the same, and change with the motion as the tangents say.
TEST_P(MarkerTargets, HaveTheTangentsOfTheirResiduals) {
    const Moved given(GetParam());
    const std::vector<int>& nodes = given.target.markers.nodes;
    const auto run_moved = [&](double by) {
        sensitivity::SensitiveTrace run;
        run.tangents.resize(1);
        run.trace.times_s = given.motion.times_s;
        for (std::size_t k = 0; k < given.motion.times_s.size(); ++k) {
            const Matrix3Xd dx = test::rough_field(given.motion.positions[k].cols(), 0.1 * static_cast<double>(k)),
                            dv = 20.0 * dx;
            Matrix3Xd x = given.model.body->mesh.nodes, v = Matrix3Xd::Zero(3, x.cols());
            x(Eigen::all, nodes) = given.motion.positions[k] + by * dx;
            v(Eigen::all, nodes) = given.motion.velocities[k] + by * dv;
            run.trace.positions.push_back(x);
            run.trace.velocities.push_back(v);
            run.tangents[0].positions.push_back(dx);
            run.tangents[0].velocities.push_back(dv);
        }
        return target_residuals(given.target, run);
    };
    const SensitiveResiduals here = run_moved(0.0), up = run_moved(1e-6), down = run_moved(-1e-6);
    const std::vector<Matrix3Xd> plain = target_residuals(given.target, given.motion);
    for (std::size_t m = 0; m < plain.size(); ++m)
        for (Eigen::Index t = 0; t < plain[m].cols(); ++t) {
            if (!plain[m].col(t).allFinite()) continue;
            EXPECT_LT((here.residuals_m[m].col(t) - plain[m].col(t)).norm(), 1e-15);
            const Vector3d difference = (up.residuals_m[m].col(t) - down.residuals_m[m].col(t)) / 2e-6;
            EXPECT_LT((here.tangents[0][m].col(t) - difference).norm(), 1e-6 * (1.0 + difference.norm()));
        }
}

INSTANTIATE_TEST_SUITE_P(PositionsAndDisplacements, MarkerTargets, testing::Bool());

}  // namespace
}  // namespace myo::inverse
