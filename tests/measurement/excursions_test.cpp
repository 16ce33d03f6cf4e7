#include "measurement/excursions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double frame_s = 0.01;
constexpr Index frames = 120;
constexpr double unseen = std::numeric_limits<double>::quiet_NaN();

Eigen::VectorXd frame_times() {
    return Eigen::VectorXd::LinSpaced(frames, 0.0, frame_s * static_cast<double>(frames - 1));
}

/// Markers at four places along a beam that is let go at 0.2 s and swings at 4 Hz, its tip by 16 mm.
std::vector<Matrix3Xd> filmed(double noise_m, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<Matrix3Xd> tracks;
    for (const double share : {0.1, 0.3, 0.6, 1.0}) {
        Matrix3Xd track(3, frames);
        for (Index t = 0; t < frames; ++t) {
            const double s = frame_s * static_cast<double>(t) - 0.2;
            track.col(t) = Vector3d(
                0.1 * std::sqrt(share), 0.0,
                s < 0.0 ? 0.0 : -0.016 * share * (1.0 - std::exp(-2.0 * s) * std::cos(8.0 * M_PI * s)));
            for (int axis = 0; axis < 3; ++axis) track(axis, t) += noise_m * noise(random);
        }
        tracks.push_back(track);
    }
    return tracks;
}

std::vector<Excursion> found_in(const std::vector<Matrix3Xd>& tracks, double noise_m) {
    return find_excursions(tracks, frame_times(),
                           Eigen::VectorXd::Constant(static_cast<Index>(tracks.size()), noise_m));
}

void displace(Matrix3Xd& track, Index first, Index end, const Vector3d& by_m) {
    track.middleCols(first, end - first).colwise() += by_m;
}

TEST(Excursions, AreFoundInAMotion) {
    for (const double noise : {3e-6, 1e-4})
        for (unsigned seed = 1; seed <= 20; ++seed) {
            std::vector<Matrix3Xd> tracks = filmed(noise, seed);
            displace(tracks[3], 40, 44, {0.0, 0.006, -0.004});
            displace(tracks[1], 50, 75, {0.004, 0.008, 0.0});
            displace(tracks[3], 80, 100, {-0.010, 0.0, 0.002});
            const std::vector<Excursion> found = found_in(tracks, noise);
            ASSERT_EQ(found.size(), 3u) << noise << " " << seed;
            const std::size_t markers[] = {3, 1, 3};
            const Index firsts[] = {40, 50, 80}, ends[] = {44, 75, 100};
            const double jumps_m[] = {std::hypot(0.006, 0.004), std::hypot(0.004, 0.008), std::hypot(0.010, 0.002)};
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_EQ(found[i].marker, markers[i]);
                EXPECT_EQ(found[i].first, firsts[i]);
                EXPECT_EQ(found[i].end, ends[i]);
                EXPECT_NEAR(found[i].jump_m, jumps_m[i], 0.0015);
            }
        }
}

/// Cameras lose the right marker before they follow another; the other rests where it is, and the body moves on.
TEST(Excursions, BeginAndEndInGapsAndFollowOtherThings) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::vector<Matrix3Xd> tracks = filmed(1e-5, seed);
        const Vector3d elsewhere = tracks[2].col(60) + Vector3d(0.0, 0.02, 0.0);
        for (Index t = 62; t < 78; ++t)
            tracks[2].col(t) = elsewhere + Vector3d::Constant(1e-5 * std::sin(static_cast<double>(t)));
        for (const Index t : {60, 61, 78}) tracks[2].col(t).setConstant(unseen);
        const std::vector<Excursion> found = found_in(tracks, 1e-5);
        ASSERT_EQ(found.size(), 1u) << seed;
        EXPECT_EQ(found[0].marker, 2u);
        EXPECT_EQ(found[0].first, 62);
        EXPECT_EQ(found[0].end, 78);
    }
}

/// Neither noise, nor a body let go, nor a marker that slips, even twice, nor two that change places, nor a body that
/// all markers show to jump.
TEST(Excursions, AreNotSeenInWhatMotionsAndOtherFaultsDo) {
    for (const double noise : {0.0, 3e-6, 1e-4})
        for (unsigned seed = 1; seed <= 50; ++seed) {
            const std::vector<Matrix3Xd> clean = filmed(noise, seed);
            EXPECT_TRUE(found_in(clean, noise).empty()) << noise << " " << seed;
            std::vector<Matrix3Xd> slipped = clean;
            displace(slipped[3], 50, frames, {0.001, 0.0, -0.003});
            displace(slipped[3], 80, frames, {0.001, 0.001, -0.003});
            EXPECT_TRUE(found_in(slipped, noise).empty()) << noise << " " << seed;
            std::vector<Matrix3Xd> swapped = clean;
            const Matrix3Xd second = swapped[1].middleCols(40, 30);
            swapped[1].middleCols(40, 30) = swapped[2].middleCols(40, 30);
            swapped[2].middleCols(40, 30) = second;
            EXPECT_TRUE(found_in(swapped, noise).empty()) << noise << " " << seed;
            std::vector<Matrix3Xd> pushed = clean;
            const double shares[] = {0.1, 0.3, 0.6, 1.0};
            for (std::size_t i = 0; i < 4; ++i) displace(pushed[i], 5, 15, {0.0, 0.02 * shares[i], 0.0});
            EXPECT_TRUE(found_in(pushed, noise).empty()) << noise << " " << seed;
        }
}

/// A marker that slips for good stays slipped, whatever happens to it besides.
TEST(Excursions, TakeNoSlipForTheirEnd) {
    std::vector<Matrix3Xd> tracks = filmed(1e-5, 1);
    displace(tracks[2], 40, frames, {0.0, 0.006, 0.0});
    displace(tracks[2], 70, 80, {0.0, 0.006, 0.0});
    const std::vector<Excursion> found = found_in(tracks, 1e-5);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].first, 70);
    EXPECT_EQ(found[0].end, 80);
}

TEST(Excursions, NeedOtherMarkersAndNeighbours) {
    std::vector<Matrix3Xd> tracks = filmed(1e-5, 1);
    displace(tracks[3], 50, 70, {0.0, 0.006, 0.0});
    EXPECT_EQ(found_in(tracks, 1e-5).size(), 1u);
    EXPECT_TRUE(found_in({tracks[2], tracks[3]}, 1e-5).empty());
    std::vector<Matrix3Xd> brief;
    for (const Matrix3Xd& track : tracks) brief.push_back(track.middleCols(48, 7));
    EXPECT_TRUE(find_excursions(brief, frame_times().head(7), Eigen::VectorXd::Constant(4, 1e-5)).empty());
    EXPECT_TRUE(find_excursions({}, Eigen::VectorXd(0), Eigen::VectorXd(0)).empty());
}

}  // namespace
}  // namespace myo::measurement
