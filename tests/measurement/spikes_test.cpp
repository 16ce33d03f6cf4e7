#include "measurement/spikes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Path = std::function<Vector3d(double)>;

constexpr double spacing_s = 0.01;

/// A beam let go at 0.2 s that swings at 4 Hz: its acceleration jumps there.
Vector3d let_go(double t) {
    const double s = t - 0.2, w = 2.0 * M_PI * 4.0;
    return s < 0.0 ? Vector3d(0.1, 0.0, 0.02)
                   : Vector3d(0.1 - 0.002 * std::pow(std::sin(w * s), 2), 0.0,
                              0.02 - 0.016 * (1.0 - std::exp(-2.0 * s) * std::cos(w * s)));
}

struct Track {
    Eigen::VectorXd time_s;
    Eigen::Matrix3Xd at;
};

Track recorded(const Path& path, Index samples, double sigma_m, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    Track track{Eigen::VectorXd::LinSpaced(samples, 0.0, spacing_s * static_cast<double>(samples - 1)),
                Eigen::Matrix3Xd(3, samples)};
    for (Index t = 0; t < samples; ++t) {
        track.at.col(t) = path(track.time_s(t));
        for (int axis = 0; axis < 3; ++axis) track.at(axis, t) += sigma_m * noise(random);
    }
    return track;
}

TEST(Spikes, AreFoundInAMotionSingleAndInShortRuns) {
    for (const double sigma : {3e-6, 1e-4})
        for (unsigned seed = 1; seed <= 20; ++seed) {
            Track track = recorded(let_go, 120, sigma, seed);
            for (const Index t : {40, 41, 70, 90, 91, 92}) track.at.col(t) += Vector3d(0.0, 0.006, -0.004);
            track.at.col(75).setConstant(std::numeric_limits<double>::quiet_NaN());  // a gap of one sample is no matter
            const Spikes spikes = find_spikes(track.at, track.time_s, sigma);
            EXPECT_EQ(spikes.samples, (std::vector<Index>{40, 41, 70, 90, 91, 92})) << sigma << " " << seed;
            EXPECT_NEAR(spikes.largest_m, std::hypot(0.006, 0.004), 0.002);
        }
}

/// Neither noise, nor a body let go, nor markers that slip or are exchanged for good, nor a stream that repeats
/// samples.
TEST(Spikes, AreNotSeenInWhatMotionsAndOtherFaultsDo) {
    for (const double sigma : {0.0, 3e-6, 1e-4})
        for (unsigned seed = 1; seed <= 50; ++seed) {
            const Track clean = recorded(let_go, 120, sigma, seed);
            EXPECT_TRUE(find_spikes(clean.at, clean.time_s, sigma).samples.empty()) << sigma << " " << seed;
            Track slipped = clean;
            slipped.at.rightCols(60).colwise() += Vector3d(0.001, 0.0, -0.003);
            EXPECT_TRUE(find_spikes(slipped.at, slipped.time_s, sigma).samples.empty()) << sigma << " " << seed;
            Track polled = clean;
            for (Index t = 5; t < 120; t += 5) polled.at.col(t) = polled.at.col(t - 1);
            EXPECT_TRUE(find_spikes(polled.at, polled.time_s, sigma).samples.empty()) << sigma << " " << seed;
        }
}

TEST(Spikes, NeedNeighbours) {
    Track track = recorded(let_go, 5, 1e-5, 1);
    track.at.col(2) += Vector3d(0.01, 0.0, 0.0);
    EXPECT_TRUE(find_spikes(track.at, track.time_s, 1e-5).samples.empty());
    EXPECT_TRUE(find_spikes(Eigen::Matrix3Xd(3, 0), Eigen::VectorXd(0), 1e-5).samples.empty());
}

}  // namespace
}  // namespace myo::measurement
