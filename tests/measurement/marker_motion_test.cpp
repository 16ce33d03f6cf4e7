#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "measurement/hermite_weights.hpp"
#include "measurement/observe.hpp"
#include "mesh/box_mesh.hpp"

// Markers between the steps of a run: weights of the curve, velocities, and the pull on nodes, which is the transpose.

namespace myo::measurement::marker_motion_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

const std::vector<double> uneven{0.0, 0.1, 0.25, 0.7};

/// Value of what weights combine from values and rates at the steps.
template <class Value, class Rate>
double combined(const HermiteWeights& w, const Value& value, const Rate& rate_at) {
    const double before = uneven[w.step], after = uneven[w.step + 1];
    return w.x0 * value(before) + w.v0 * rate_at(before) + w.x1 * value(after) + w.v1 * rate_at(after);
}

TEST(HermiteWeights, ReproduceCubicsAndTheirRates) {
    const auto cubic = [](double t) { return 1.0 - 2.0 * t + 3.0 * t * t - 4.0 * t * t * t; };
    const auto slope = [](double t) { return -2.0 + 6.0 * t - 12.0 * t * t; };
    for (double t = 0.003; t < 0.7; t += 0.0123) {
        const HermiteWeights w = hermite_weights(uneven, t);
        EXPECT_LE(uneven[w.step], t);
        EXPECT_LT(t, uneven[w.step + 1]);
        EXPECT_NEAR(combined(w, cubic, slope), cubic(t), 4e-15) << t;
        EXPECT_NEAR(combined(w.rate(), cubic, slope), slope(t), 1e-13) << t;
    }
    // A quartic is beyond it: off by its coefficient times s^2 (1 - s)^2 h^4.
    const auto fourth = [](double t) { return t * t * t * t; };
    const auto fourth_slope = [](double t) { return 4.0 * t * t * t; };
    const double h = 0.45, s = 0.3;
    EXPECT_NEAR(combined(hermite_weights(uneven, 0.25 + s * h), fourth, fourth_slope),
                fourth(0.25 + s * h) - s * s * (1 - s) * (1 - s) * h * h * h * h, 4e-15);
}

TEST(HermiteWeights, AreThoseOfTheStepAtSteps) {
    for (std::size_t k = 1; k + 1 < uneven.size(); ++k) {
        const HermiteWeights w = hermite_weights(uneven, uneven[k]);
        EXPECT_EQ(w.step, k);
        EXPECT_EQ(w.x0, 1.0);
        EXPECT_EQ(w.v0, 0.0);
        EXPECT_EQ(w.x1, 0.0);
        EXPECT_EQ(w.v1, 0.0);
        const HermiteWeights before = hermite_weights(uneven, std::nextafter(uneven[k], 0.0));
        EXPECT_EQ(before.step, k - 1);
        EXPECT_NEAR(before.x1, 1.0, 1e-14) << "no jump";
        EXPECT_NEAR(before.dv1, 1.0, 1e-13);
        EXPECT_NEAR(before.x0 + before.x1, 1.0, 1e-15);
    }
}

/// Rest before the start; at the end the last velocity, and behind it none.
TEST(HermiteWeights, RestOutsideTheRun) {
    for (const double t : {-1.0, 0.0}) {
        const HermiteWeights w = hermite_weights(uneven, t);
        EXPECT_EQ(w.step, 0u);
        EXPECT_EQ(w.x0, 1.0);
        EXPECT_EQ(w.x1, 0.0);
        for (const double rate_weight : {w.dx0, w.dv0, w.dx1, w.dv1}) EXPECT_EQ(rate_weight, 0.0);
    }
    for (const double t : {0.7, std::nextafter(0.7, 1.0), 5.0}) {
        const HermiteWeights w = hermite_weights(uneven, t);
        EXPECT_EQ(w.step, 2u);
        EXPECT_EQ(w.x0, 0.0);
        EXPECT_EQ(w.x1, 1.0);
        EXPECT_EQ(w.dv1, t > 0.7 ? 0.0 : 1.0);
        for (const double other : {w.v0, w.v1, w.dx0, w.dv0, w.dx1}) EXPECT_EQ(other, 0.0);
    }
    const HermiteWeights single = hermite_weights({0.5}, 9.0);
    EXPECT_EQ(single.step, 0u);
    EXPECT_EQ(single.x0, 1.0);
}

/// A block with three markers: in a face, on a stalk, and in an edge shared with the face of the first.
struct Marked {
    mesh::VolumeMesh mesh = mesh::box_hex_mesh({{0, 0, 0}, {0.1, 0.03, 0.03}}, {3, 1, 2});
    MarkerSet markers = marker_set(mesh, {{0.0612, 0.0, 0.0113}, {0.08, -0.006, 0.024}, {0.05, 0.0, 0.03}});
    std::vector<double> times_s{0.0, 0.01, 0.03, 0.04};
};

/// Motion of the nodes that markers depend on: moved and moving at random.
sensitivity::NodeMotion random_motion(const Marked& marked, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    const auto field = [&](double size) -> Matrix3Xd {
        return Matrix3Xd(3, static_cast<Index>(marked.markers.nodes.size())).unaryExpr([&](double) {
            return size * part(random);
        });
    };
    sensitivity::NodeMotion motion{marked.times_s, {}, {}};
    for (std::size_t k = 0; k < marked.times_s.size(); ++k) {
        motion.positions.push_back(marked.mesh.nodes(Eigen::all, marked.markers.nodes) + field(0.002));
        motion.velocities.push_back(field(0.3));
    }
    return motion;
}

const VectorXd observed_s = (VectorXd(8) << -0.1, 0.0, 0.004, 0.01, 0.022, 0.0399, 0.04, 0.2).finished();

TEST(MarkerSet, ListsItsNodesOnce) {
    const Marked marked;
    EXPECT_TRUE(std::is_sorted(marked.markers.nodes.begin(), marked.markers.nodes.end()));
    EXPECT_EQ(std::adjacent_find(marked.markers.nodes.begin(), marked.markers.nodes.end()), marked.markers.nodes.end());
    std::size_t listed = 0;
    for (std::size_t m = 0; m < 3; ++m) {
        const MarkerBinding& binding = marked.markers.bindings[m];
        ASSERT_EQ(marked.markers.positions[m].size(), binding.nodes.size());
        for (std::size_t i = 0; i < binding.nodes.size(); ++i)
            EXPECT_EQ(marked.markers.nodes[static_cast<std::size_t>(marked.markers.positions[m][i])], binding.nodes[i]);
        listed += binding.nodes.size();
    }
    EXPECT_LT(marked.markers.nodes.size(), listed) << "cells share nodes";
}

/// A whole run and the motion of the markers' nodes alone give the same tracks.
TEST(ObserveMotion, NeedsTheNodesOfTheMarkersOnly) {
    const Marked marked;
    const sensitivity::NodeMotion motion = random_motion(marked, 1);
    dynamics::Trace trace;
    trace.times_s = motion.times_s;
    for (std::size_t k = 0; k < motion.times_s.size(); ++k) {
        trace.positions.push_back(Matrix3Xd::Constant(3, marked.mesh.node_count(), 1e3));  // of other nodes
        trace.velocities.push_back(Matrix3Xd::Constant(3, marked.mesh.node_count(), 1e3));
        trace.positions[k](Eigen::all, marked.markers.nodes) = motion.positions[k];
        trace.velocities[k](Eigen::all, marked.markers.nodes) = motion.velocities[k];
    }
    const MarkerTracks whole = observe(trace, marked.markers, observed_s),
                       alone = observe(motion, marked.markers, observed_s);
    for (std::size_t m = 0; m < 3; ++m) {
        EXPECT_LT((whole.positions[m] - alone.positions[m]).norm(), 1e-15);
        EXPECT_LT((whole.velocities[m] - alone.velocities[m]).norm(), 1e-13);
    }
}

TEST(ObserveMotion, VelocitiesAreRatesOfThePlaces) {
    const Marked marked;
    const sensitivity::NodeMotion motion = random_motion(marked, 2);
    const VectorXd times = Eigen::Vector4d(0.003, 0.0123, 0.029, 0.0377);
    const double h = 1e-7;
    const MarkerTracks at = observe(motion, marked.markers, times),
                       after = observe(motion, marked.markers, times.array() + h),
                       before = observe(motion, marked.markers, times.array() - h);
    for (std::size_t m = 0; m < 3; ++m) {
        const Matrix3Xd difference = (after.positions[m] - before.positions[m]) / (2.0 * h);
        EXPECT_GT(difference.norm(), 0.01);
        EXPECT_LT((at.velocities[m] - difference).norm(), 1e-6 * difference.norm()) << m;
        EXPECT_NE(at.velocities[m], difference);
    }
}

/// Tangents of a run are observed as the difference of two runs.
TEST(ObserveMotion, TangentsAreDifferencesOfTracks) {
    const Marked marked;
    const sensitivity::NodeMotion motion = random_motion(marked, 3), along = random_motion(marked, 4);
    const auto trace_at = [&](double step) {
        dynamics::Trace trace;
        trace.times_s = motion.times_s;
        for (std::size_t k = 0; k < motion.times_s.size(); ++k) {
            Matrix3Xd x = marked.mesh.nodes, v = Matrix3Xd::Zero(3, x.cols());
            x(Eigen::all, marked.markers.nodes) = motion.positions[k] + step * along.positions[k];
            v(Eigen::all, marked.markers.nodes) = motion.velocities[k] + step * along.velocities[k];
            trace.positions.push_back(x);
            trace.velocities.push_back(v);
        }
        return trace;
    };
    sensitivity::SensitiveTrace run;
    run.trace = trace_at(0.0);
    run.tangents.push_back({along.positions, along.velocities});
    const SensitiveTracks seen = observe(run, marked.markers, observed_s);
    const double h = 1e-6;
    const MarkerTracks over = observe(trace_at(h), marked.markers, observed_s),
                       under = observe(trace_at(-h), marked.markers, observed_s);
    ASSERT_EQ(seen.tangents.size(), 1u);
    for (std::size_t m = 0; m < 3; ++m) {
        const Matrix3Xd difference = (over.positions[m] - under.positions[m]) / (2.0 * h);
        EXPECT_LT((seen.tangents[0][m] - difference).norm(), 1e-7 * difference.norm()) << m;
    }
}

TEST(PullOnNodes, IsTheTransposeOfObserve) {
    const Marked marked;
    const sensitivity::NodeMotion motion = random_motion(marked, 5), along = random_motion(marked, 6);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    std::vector<Matrix3Xd> pulls(3, Matrix3Xd(3, observed_s.size()));
    for (Matrix3Xd& pull : pulls)
        for (double& force : pull.reshaped()) force = part(random);
    pulls[1].col(3).setZero();  // a sample that does not count
    const auto loss_at = [&](double step) {
        sensitivity::NodeMotion moved = motion;
        for (std::size_t k = 0; k < moved.times_s.size(); ++k) {
            moved.positions[k] += step * along.positions[k];
            moved.velocities[k] += step * along.velocities[k];
        }
        const MarkerTracks tracks = observe(moved, marked.markers, observed_s);
        double loss = 0.0;
        for (std::size_t m = 0; m < 3; ++m) loss += pulls[m].cwiseProduct(tracks.positions[m]).sum();
        return loss;
    };
    const sensitivity::MotionLoss pulled = pull_on_nodes(motion, marked.markers, observed_s, pulls);
    double slope = 0.0;
    for (std::size_t k = 0; k < motion.times_s.size(); ++k)
        slope += pulled.d_positions[k].cwiseProduct(along.positions[k]).sum() +
                 pulled.d_velocities[k].cwiseProduct(along.velocities[k]).sum();
    const double h = 1e-6, difference = (loss_at(h) - loss_at(-h)) / (2.0 * h);
    EXPECT_EQ(pulled.value, 0.0);
    EXPECT_GT(std::abs(difference), 1e-3);
    EXPECT_NEAR(slope, difference, 1e-7);
    // Samples before the start act on the first positions alone.
    const sensitivity::MotionLoss early = pull_on_nodes(motion, marked.markers, VectorXd::Constant(8, -1.0), pulls);
    EXPECT_GT(early.d_positions[0].norm(), 0.1);
    for (std::size_t k = 1; k < motion.times_s.size(); ++k) EXPECT_TRUE(early.d_positions[k].isZero(0.0));
    for (const Matrix3Xd& velocity : early.d_velocities) EXPECT_TRUE(velocity.isZero(0.0));
}

}  // namespace
}  // namespace myo::measurement::marker_motion_test
