#include "measurement/false_stretches.hpp"

#include <gtest/gtest.h>

#include "measurement/swinging_markers.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using test::hide;
using test::swinging_markers;

std::vector<FalseStretch> stretches_in(const std::vector<Matrix3Xd>& tracks, double noise_m) {
    return find_false_stretches(tracks, Eigen::VectorXd::Constant(static_cast<Index>(tracks.size()), noise_m));
}

struct Hidden {
    Index before, after;  // hidden samples at the beginning and at the end of the stretch
};

/// Another marker is followed behind a gap, in front of one, or between two, whatever their length; at rest and in the
/// swing.
TEST(FalseStretches, BeginOrEndAtGapsOfAnyLength) {
    for (const double noise : {1e-5, 1e-4})
        for (unsigned seed = 1; seed <= 4; ++seed)
            for (const std::size_t marker : {1u, 4u})
                for (const Index first : {16, 40})
                    for (const Hidden& gap : {Hidden{1, 0}, {0, 1}, {3, 0}, {12, 0}, {0, 12}, {1, 1}, {10, 5}}) {
                        std::vector<Matrix3Xd> tracks = swinging_markers(noise, seed);
                        tracks[marker].middleCols(first, 20).colwise() += Vector3d(0.03, 0.03, 0.0);
                        hide(tracks[marker], first - gap.before, first);
                        hide(tracks[marker], first + 20, first + 20 + gap.after);
                        const std::vector<FalseStretch> found = stretches_in(tracks, noise);
                        ASSERT_EQ(found.size(), 1u) << noise << " " << seed << " " << marker << " " << first << " "
                                                    << gap.before << " " << gap.after;
                        EXPECT_EQ(found[0].marker, marker);
                        EXPECT_EQ(found[0].first, first);
                        EXPECT_EQ(found[0].end, first + 20);
                        EXPECT_NEAR(found[0].offset_m, std::hypot(0.03, 0.03), 0.003);
                    }
}

TEST(FalseStretches, MayBeSeveralAndRestSomewhere) {
    std::vector<Matrix3Xd> tracks = swinging_markers(1e-4, 1);
    tracks[2].middleCols(30, 12) = (tracks[2].col(29) + Vector3d(0.0, 0.02, 0.01)).replicate(1, 12);
    hide(tracks[2], 42, 45);
    tracks[4].middleCols(70, 10).colwise() += Vector3d(0.0, -0.05, 0.0);
    hide(tracks[4], 60, 70);
    hide(tracks[4], 74, 76);
    const std::vector<FalseStretch> found = stretches_in(tracks, 1e-4);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].marker, 2u);
    EXPECT_EQ(found[0].first, 30);
    EXPECT_EQ(found[0].end, 42);
    EXPECT_EQ(found[1].marker, 4u);
    EXPECT_EQ(found[1].first, 70);
    EXPECT_EQ(found[1].end, 80) << "with the gap inside";
}

/// No true sample is lost: gaps anywhere, in several markers at once, a marker that slips for good, and one that slips
/// beside a gap.
TEST(FalseStretches, AreNotSeenInWhatMotionsAndOtherFaultsDo) {
    for (const double noise : {0.0, 1e-5, 1e-4, 5e-4})
        for (unsigned seed = 1; seed <= 25; ++seed) {
            std::mt19937 random(seed);
            std::vector<Matrix3Xd> tracks = swinging_markers(noise, seed);
            for (Matrix3Xd& track : tracks)
                for (int gap = 0; gap < 3; ++gap) {
                    const Index first = std::uniform_int_distribution<Index>(1, 95)(random);
                    hide(track, first, first + std::uniform_int_distribution<Index>(1, 20)(random));
                }
            EXPECT_TRUE(stretches_in(tracks, noise).empty()) << noise << " " << seed;
            std::vector<Matrix3Xd> slipped = swinging_markers(noise, seed);
            slipped[3].rightCols(70).colwise() += Vector3d(0.002, 0.0, -0.008);
            hide(slipped[3], 80, 85);
            EXPECT_TRUE(stretches_in(slipped, noise).empty()) << noise << " " << seed;
            hide(slipped[3], 48, 52);
            EXPECT_TRUE(stretches_in(slipped, noise).empty()) << noise << " " << seed;
        }
    EXPECT_TRUE(stretches_in({}, 1e-4).empty());
    std::vector<Matrix3Xd> two = swinging_markers(1e-4, 1);
    two.resize(2);
    two[0].middleCols(40, 20).colwise() += Vector3d(0.03, 0.03, 0.0);
    hide(two[0], 60, 65);
    EXPECT_TRUE(stretches_in(two, 1e-4).empty()) << "one other marker cannot tell";
}

}  // namespace
}  // namespace myo::measurement
