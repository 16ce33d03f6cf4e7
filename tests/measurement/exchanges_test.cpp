#include "measurement/exchanges.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double dt_s = 0.01;
constexpr Index take_samples = 120;

/// Four markers on the end of a beam that swings at 4 Hz: two 3 cm apart, and two at half its length.
std::vector<Matrix3Xd> recorded(double swing_m, double noise_m, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<Matrix3Xd> tracks;
    for (const auto& [place, share] : {std::pair{Vector3d(0.1, 0.015, 0.0), 1.0},
                                       {Vector3d(0.1, -0.015, 0.0), 1.0},
                                       {Vector3d(0.05, 0.015, 0.01), 0.3},
                                       {Vector3d(0.05, -0.015, 0.01), 0.3}}) {
        Matrix3Xd track(3, take_samples);
        for (Index t = 0; t < take_samples; ++t) {
            const double phase = 2.0 * M_PI * 4.0 * dt_s * static_cast<double>(t);
            track.col(t) = place + share * swing_m * Vector3d(0.0, std::sin(phase), 0.3 * std::cos(phase));
            for (int axis = 0; axis < 3; ++axis) track(axis, t) += noise_m * noise(random);
        }
        tracks.push_back(track);
    }
    return tracks;
}

void exchange(std::vector<Matrix3Xd>& tracks, std::size_t a, std::size_t b, Index first, Index length) {
    const Matrix3Xd of_a = tracks[a].middleCols(first, length);
    tracks[a].middleCols(first, length) = tracks[b].middleCols(first, length);
    tracks[b].middleCols(first, length) = of_a;
}

/// Seen in the same samples at the same places.
bool same(const std::vector<Matrix3Xd>& a, const std::vector<Matrix3Xd>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        for (Index t = 0; t < take_samples; ++t)
            if (a[i].col(t).allFinite() != b[i].col(t).allFinite() ||
                (a[i].col(t).allFinite() && a[i].col(t) != b[i].col(t)))
                return false;
    return true;
}

TEST(Exchanges, ArePutBack) {
    for (const double noise : {0.0, 1e-5, 2e-4})
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const std::vector<Matrix3Xd> true_tracks = recorded(0.015, noise, seed);
            for (const Index length : {1, 4, 10, 60}) {
                std::vector<Matrix3Xd> tracks = true_tracks;
                exchange(tracks, 0, 1, 30, length);
                const std::vector<Exchange> found = put_back_exchanges(tracks);
                ASSERT_EQ(found.size(), 1u) << noise << " " << seed << " " << length;
                EXPECT_EQ(found[0].markers, (std::vector<std::size_t>{0, 1}));
                EXPECT_EQ(found[0].first, 30);
                EXPECT_EQ(found[0].end, 30 + length);
                EXPECT_TRUE(same(tracks, true_tracks));
            }
        }
}

TEST(Exchanges, ArePutBackBesideGapsAndInRings) {
    std::vector<Matrix3Xd> true_tracks = recorded(0.01, 1e-4, 1);
    // Where cameras lose sight of markers they name them anew.
    for (const std::size_t i : {0u, 1u})
        true_tracks[i].middleCols(40, 5).setConstant(std::numeric_limits<double>::quiet_NaN());
    std::vector<Matrix3Xd> tracks = true_tracks;
    exchange(tracks, 0, 1, 45, 20);
    exchange(tracks, 2, 3, 50, 30);
    // 1 -> 2 -> 3 -> 1
    exchange(tracks, 1, 2, 90, 10);
    exchange(tracks, 2, 3, 90, 10);
    const std::vector<Exchange> found = put_back_exchanges(tracks);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].markers.size(), 4u);
    EXPECT_EQ(found[1].markers, (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_TRUE(same(tracks, true_tracks));
}

/// One marker is lost, and names are exchanged as it is found again, far from where it was seen last.
TEST(Exchanges, ArePutBackWhereOneAloneWasLost) {
    for (const double swing : {0.005, 0.015, 0.04})
        for (unsigned seed = 1; seed <= 20; ++seed)
            for (const std::size_t lost : {0u, 1u}) {
                std::vector<Matrix3Xd> true_tracks = recorded(swing, 1e-4, seed);
                true_tracks[lost].middleCols(40, 8).setConstant(std::numeric_limits<double>::quiet_NaN());
                std::vector<Matrix3Xd> tracks = true_tracks;
                exchange(tracks, 0, 1, 48, 30);
                const std::vector<Exchange> found = put_back_exchanges(tracks);
                ASSERT_EQ(found.size(), 1u) << swing << " " << seed;
                EXPECT_EQ(found[0].first, 48);
                EXPECT_EQ(found[0].end, 78);
                EXPECT_TRUE(same(tracks, true_tracks));
            }
}

/// Names that are not given back, a marker that slips or takes another's place, and swings of several times the
/// distance of the markers.
TEST(Exchanges, AreNotSeenInWhatMotionsAndOtherFaultsDo) {
    for (const double noise : {0.0, 1e-5, 5e-4})
        for (unsigned seed = 1; seed <= 20; ++seed)
            for (const double swing : {0.0, 0.015, 0.1}) {
                std::vector<Matrix3Xd> tracks = recorded(swing, noise, seed), before = tracks;
                EXPECT_TRUE(put_back_exchanges(tracks).empty()) << noise << " " << swing;
                exchange(tracks, 0, 1, 70, take_samples - 70);
                tracks[2].rightCols(50).colwise() += Vector3d(0.0, -0.03, 0.0);  // to where the fourth is
                tracks[3].middleCols(20, 6).setConstant(std::numeric_limits<double>::quiet_NaN());
                before = tracks;
                EXPECT_TRUE(put_back_exchanges(tracks).empty()) << noise << " " << swing;
                EXPECT_TRUE(same(tracks, before));
            }
    std::vector<Matrix3Xd> none;
    EXPECT_TRUE(put_back_exchanges(none).empty());
}

void hide_marker(std::vector<Matrix3Xd>& tracks, std::size_t marker, Index first, Index end) {
    tracks[marker].middleCols(first, end - first).setConstant(std::numeric_limits<double>::quiet_NaN());
}

/// Cameras relabel what they lost: names that were exchanged in a gap of both are put back although nothing exchanges
/// them again, also where the markers are lost and found one after the other, and in rings of three.
TEST(Exchanges, ThatBeginInACommonGapArePutBackToTheEnd) {
    for (const double swing : {0.005, 0.03})
        for (unsigned seed = 1; seed <= 10; ++seed)
            for (const Index late : {0, 3}) {
                std::vector<Matrix3Xd> true_tracks = recorded(swing, 1e-4, seed);
                hide_marker(true_tracks, 0, 40, 50);
                hide_marker(true_tracks, 1, 40 - late, 50 + late);
                std::vector<Matrix3Xd> tracks = true_tracks;
                exchange(tracks, 0, 1, 45, take_samples - 45);
                const std::vector<Exchange> found = put_back_exchanges(tracks);
                ASSERT_EQ(found.size(), 1u) << swing << " " << seed << " " << late;
                EXPECT_EQ(found[0].markers, (std::vector<std::size_t>{0, 1}));
                EXPECT_EQ(found[0].first, 50);
                EXPECT_EQ(found[0].end, take_samples);
                EXPECT_TRUE(same(tracks, true_tracks));

                std::vector<Matrix3Xd> ring_tracks = recorded(swing, 1e-4, seed);
                for (const std::size_t i : {0u, 1u, 2u}) hide_marker(ring_tracks, i, 40, 50);
                tracks = ring_tracks;
                exchange(tracks, 0, 1, 50, take_samples - 50);
                exchange(tracks, 1, 2, 50, take_samples - 50);
                ASSERT_EQ(put_back_exchanges(tracks).size(), 1u) << swing << " " << seed;
                EXPECT_TRUE(same(tracks, ring_tracks));
            }
}

/// Neither gaps alone, nor a body that turns round in one.
TEST(Exchanges, AreNotSeenInGapsOrTurns) {
    for (const double noise : {0.0, 5e-4})
        for (unsigned seed = 1; seed <= 20; ++seed) {
            std::mt19937 random(seed);
            std::vector<Matrix3Xd> tracks = recorded(0.03, noise, seed);
            for (std::size_t i = 0; i < 4; ++i) {
                const Index first = std::uniform_int_distribution<Index>(1, 60)(random);
                hide_marker(tracks, i, first, first + std::uniform_int_distribution<Index>(1, 40)(random));
            }
            EXPECT_TRUE(put_back_exchanges(tracks).empty()) << noise << " " << seed;
        }
    std::vector<Matrix3Xd> turned = recorded(0.0, 1e-5, 1);
    for (Matrix3Xd& track : turned)
        for (Index t = 0; t < take_samples; ++t) {
            const double angle = M_PI * std::clamp((static_cast<double>(t) - 30.0) / 40.0, 0.0, 1.0);
            track.col(t) = Eigen::AngleAxisd(angle, Vector3d::UnitX()) * track.col(t);
        }
    for (const std::size_t i : {0u, 1u}) hide_marker(turned, i, 30, 70);
    EXPECT_TRUE(put_back_exchanges(turned).empty());
}

}  // namespace
}  // namespace myo::measurement
