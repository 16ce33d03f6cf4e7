#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "measurement/observation_error.hpp"
#include "support/turning_mount.hpp"

// From the mount's frame to what cameras record: motion of the mount, shifts, exchanged labels, scale, lenses. Every
// derivative is compared with differences of the tracks.

namespace myo::measurement::observation_chain_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Tracks = std::vector<Matrix3Xd>;

Tracks random_tracks(std::size_t markers, Index samples, unsigned seed, double size_m = 0.1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-size_m, size_m);
    Tracks tracks(markers, Matrix3Xd(3, samples));
    for (Matrix3Xd& track : tracks)
        for (double& x : track.reshaped()) x = place(random);
    return tracks;
}

Tracks sum(const Tracks& a, double factor, const Tracks& b) {
    Tracks result = a;
    for (std::size_t m = 0; m < a.size(); ++m) result[m] += factor * b[m];
    return result;
}

/// Largest entry of the difference.
double apart(const Tracks& a, const Tracks& b) {
    double largest = 0.0;
    for (std::size_t m = 0; m < a.size(); ++m) largest = std::max(largest, (a[m] - b[m]).cwiseAbs().maxCoeff());
    return largest;
}

double largest_of(const Tracks& a) {
    double largest = 0.0;
    for (const Matrix3Xd& track : a) largest = std::max(largest, track.cwiseAbs().maxCoeff());
    return largest;
}

/// A lens that bends lines by so much per square metre and drifts by so many metres per second along z.
Lens bending(double bend, double drift) {
    return [=](const Vector3d& p, double stamped_s) {
        const double r2 = p.squaredNorm();
        return SeenPlace{p * (1.0 + bend * r2) + drift * stamped_s * Vector3d::UnitZ(),
                         (1.0 + bend * r2) * Matrix3d::Identity() + 2.0 * bend * p * p.transpose()};
    };
}

const VectorXd stamps = VectorXd::LinSpaced(6, -0.1, 0.4);

ObservationError everything_wrong() {
    ObservationError error;
    error.scale_error = 0.03;
    error.swaps = {{0, 1, 0.1}, {1, 2, 0.25}};
    error.shifts = {{2, Vector3d(0.01, -0.02, 0.03), 0.2}};
    error.lenses = {bending(0.8, 0.05), bending(-0.5, -0.2)};
    return error;
}

TEST(ObservedTracks, ChangeLabelsOneExchangeAfterTheOther) {
    ObservationError error;
    error.swaps = {{0, 1, 0.1}, {1, 2, 0.1}};
    const VectorXd times = Eigen::Vector2d(std::nextafter(0.1, 0.0), 0.1);
    Tracks tracks;
    for (const double x : {1.0, 2.0, 3.0}) tracks.push_back(Matrix3Xd::Constant(3, 2, x));
    const Tracks seen = observed_tracks(error, tracks, times);
    for (std::size_t m = 0; m < 3; ++m) EXPECT_EQ(seen[m](0, 0), tracks[m](0, 0)) << "before the time";
    EXPECT_EQ(seen[0](0, 1), 2.0);
    EXPECT_EQ(seen[1](0, 1), 3.0) << "the second exchange acts on the labels of the first";
    EXPECT_EQ(seen[2](0, 1), 1.0);
}

/// A shift belongs to the marker, so it goes with its label; scale and lenses come last.
TEST(ObservedTracks, ShiftThenExchangeThenScaleThenLens) {
    ObservationError error;
    error.shifts = {{0, Vector3d(1.0, 0.0, 0.0), 0.0}};
    error.swaps = {{0, 1, 0.0}};
    error.scale_error = 0.5;
    error.lenses = {bending(0.1, 0.0), [](const Vector3d& p, double) { return SeenPlace{p + Vector3d::UnitY(), {}}; }};
    const VectorXd time = VectorXd::Zero(1);
    const Tracks seen = observed_tracks(error, {Matrix3Xd(Vector3d(1.0, 0, 0)), Matrix3Xd(Vector3d(4.0, 0, 0))}, time);
    const auto through = [](double x) { return Vector3d(x * (1.0 + 0.1 * x * x), 1.0, 0.0); };
    EXPECT_LT((seen[0].col(0) - through(6.0)).norm(), 1e-14);
    EXPECT_LT((seen[1].col(0) - through(3.0)).norm(), 1e-14);
}

TEST(ObservedTangents, AreDerivativesOfTheTracks) {
    const ObservationError error = everything_wrong();
    const Tracks tracks = random_tracks(3, stamps.size(), 1), along = random_tracks(3, stamps.size(), 2, 1.0);
    const double h = 1e-5;
    Tracks difference = sum(observed_tracks(error, sum(tracks, h, along), stamps), -1.0,
                            observed_tracks(error, sum(tracks, -h, along), stamps));
    for (Matrix3Xd& track : difference) track /= 2.0 * h;
    const Tracks tangents = observed_tangents(error, along, tracks, stamps);
    EXPECT_GT(largest_of(tangents), 0.5);
    EXPECT_LT(apart(tangents, difference), 5e-9);
    EXPECT_GT(apart(tangents, difference), 0.0);
    EXPECT_GT(apart(tangents, along), 0.1) << "what is wrong is seen in them";
    // Markers that do not move stay out of it, named or not.
    ObservationError without_swaps = error;
    without_swaps.swaps.clear();
    Tracks one_moves(3, Matrix3Xd(3, 0));
    one_moves[1] = along[1];
    const Tracks of_one = observed_tangents(without_swaps, one_moves, tracks, stamps);
    EXPECT_EQ(of_one[0].cols(), 0);
    EXPECT_EQ(of_one[1], observed_tangents(without_swaps, along, tracks, stamps)[1]);
}

TEST(SeenByPlace, IsTheDerivativeBeforeTheRecording) {
    ObservationError error = everything_wrong();
    error.swaps.clear();
    error.shifts.clear();
    const Vector3d place(0.3, -0.2, 0.5);
    const VectorXd before = VectorXd::Constant(1, -3.0);
    const auto seen = [&](const Vector3d& p) -> Vector3d {
        return observed_tracks(error, {Matrix3Xd(p)}, before)[0].col(0);
    };
    Matrix3d difference;
    const double h = 1e-5;
    for (int axis = 0; axis < 3; ++axis)
        difference.col(axis) = (seen(place + h * Vector3d::Unit(axis)) - seen(place - h * Vector3d::Unit(axis))) /
                               (2.0 * h);
    const Matrix3d slope = seen_by_place(error, place);
    EXPECT_LT((slope - difference).norm(), 3e-9);
    EXPECT_NE(slope, difference);
    EXPECT_GT((slope - Matrix3d::Identity()).norm(), 0.1);
    EXPECT_EQ(seen_by_place({}, place), Matrix3d::Identity());
}

/// A lens that is bumped at some time was still whole before the recording began.
TEST(Lenses, AreAskedForTheirStateFromTheStartOn) {
    std::vector<double> asked;
    ObservationError error;
    error.lenses = {[&](const Vector3d& p, double stamped_s) {
        asked.push_back(stamped_s);
        return SeenPlace{p, Matrix3d::Identity()};
    }};
    const VectorXd times = Eigen::Vector3d(-2.0, 0.0, 0.5);
    EXPECT_EQ(observed_tracks(error, random_tracks(1, 3, 3), times), random_tracks(1, 3, 3));
    EXPECT_EQ(asked, (std::vector<double>{0.0, 0.0, 0.5}));
}

TEST(LaboratoryTracks, FollowTheMount) {
    ObservationError error;
    const Tracks tracks = random_tracks(2, stamps.size(), 4);
    EXPECT_EQ(laboratory_tracks(error, tracks, stamps), tracks);
    const auto mount = test::tumbling_mount();
    error.mount = mount;
    const Tracks seen = laboratory_tracks(error, tracks, stamps);
    for (Index t = 0; t < stamps.size(); ++t) {
        const model::MountPose pose = mount->at(stamps(t));
        for (std::size_t m = 0; m < 2; ++m) {
            const Vector3d expected = pose.rotation * (tracks[m].col(t) - pose.pivot_m) + pose.place_m;
            EXPECT_LT((seen[m].col(t) - expected).norm(), 1e-15);
        }
    }
    EXPECT_GT(apart(seen, tracks), 0.05);
}

TEST(LaboratoryTangents, TurnWithTheMountAndDoNotTravel) {
    ObservationError error;
    const Tracks tracks = random_tracks(2, stamps.size(), 5), along = random_tracks(2, stamps.size(), 6, 1.0);
    EXPECT_EQ(laboratory_tangents(error, along, stamps), along);
    error.mount = test::tumbling_mount();
    // The tracks are linear in the places: a difference of any width is the derivative, up to rounding.
    const Tracks difference = sum(laboratory_tracks(error, sum(tracks, 1.0, along), stamps), -1.0,
                                  laboratory_tracks(error, tracks, stamps));
    EXPECT_LT(apart(laboratory_tangents(error, along, stamps), difference), 1e-14);
    EXPECT_GT(apart(difference, along), 0.1);
    auto sliding = std::make_shared<test::TurningMount>();
    sliding->drift_m_s = {1.0, 2.0, 3.0};
    error.mount = sliding;
    EXPECT_EQ(laboratory_tangents(error, along, stamps), along);
}

/// Velocities seen in the laboratory are the rates of the places seen there, for markers that move on the mount.
TEST(LaboratoryVelocities, AreRatesOfLaboratoryTracks) {
    const VectorXd times = VectorXd::LinSpaced(5, 0.02, 0.3);
    const auto place = [](double t) {
        return Vector3d(0.05 * std::sin(9.0 * t), 0.02 * t * t, 0.03 * std::cos(4.0 * t));
    };
    const auto velocity = [](double t) {
        return Vector3d(0.45 * std::cos(9.0 * t), 0.04 * t, -0.12 * std::sin(4.0 * t));
    };
    ObservationError error;
    error.mount = test::tumbling_mount();
    const auto tracks_at = [&](double shift_s) {
        Matrix3Xd track(3, times.size());
        for (Index t = 0; t < times.size(); ++t) track.col(t) = place(times(t) + shift_s);
        return Tracks{track};
    };
    Matrix3Xd speeds(3, times.size());
    for (Index t = 0; t < times.size(); ++t) speeds.col(t) = velocity(times(t));
    const Tracks seen = laboratory_velocities(error, tracks_at(0.0), {speeds}, times);
    const double h = 1e-6;
    Tracks difference = sum(laboratory_tracks(error, tracks_at(h), times.array() + h), -1.0,
                            laboratory_tracks(error, tracks_at(-h), times.array() - h));
    difference[0] /= 2.0 * h;
    EXPECT_LT(apart(seen, difference), 1e-7);
    EXPECT_GT(apart(seen, {speeds}), 0.1) << "the mount moves it as well";
    EXPECT_EQ(laboratory_velocities({}, tracks_at(0.0), {speeds}, times), Tracks{speeds});
}

}  // namespace
}  // namespace myo::measurement::observation_chain_test
