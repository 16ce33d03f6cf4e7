#include "measurement/frozen.hpp"

#include <gtest/gtest.h>

#include "measurement/noise.hpp"
#include "measurement/swinging_markers.hpp"
#include "measurement/zeros.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using test::swinging_markers;

void freeze(Matrix3Xd& track, Index first, Index end) {
    for (Index t = first; t < end; ++t) track.col(t) = track.col(first - 1);
}

/// Rounded as files are.
std::vector<Matrix3Xd> written(std::vector<Matrix3Xd> tracks, double step_m) {
    for (Matrix3Xd& track : tracks) track = (track / step_m).array().round() * step_m;
    return tracks;
}

std::vector<FrozenInterval> frozen_in(const std::vector<Matrix3Xd>& tracks) {
    return find_frozen(tracks, rounding_step(tracks));
}

TEST(Frozen, ExactRepetitionInAMotionIsFound) {
    for (const double noise : {0.0, 1e-5, 1e-4})
        for (const double step : {1e-6, 1e-5})
            for (unsigned seed = 1; seed <= 10; ++seed)
                for (const Index length : {6, 40}) {
                    std::vector<Matrix3Xd> tracks = written(swinging_markers(noise, seed), step);
                    freeze(tracks[3], 45, 45 + length);
                    const std::vector<FrozenInterval> found = frozen_in(tracks);
                    ASSERT_EQ(found.size(), 1u) << noise << " " << step << " " << seed << " " << length;
                    EXPECT_EQ(found[0].marker, 3u);
                    EXPECT_EQ(found[0].first, 45) << "the sample that is repeated is true";
                    EXPECT_EQ(found[0].end, 45 + length);
                }
    std::vector<Matrix3Xd> last = written(swinging_markers(1e-4, 1), 1e-6);
    freeze(last[0], 80, 120);
    ASSERT_EQ(frozen_in(last).size(), 1u);
    EXPECT_EQ(frozen_in(last)[0].end, 120) << "to the end";
}

/// A body at rest in a coarse file, a stream that repeats all markers, a marker on the mount, and one that rests by
/// itself in a file that hides the noise.
TEST(Frozen, NaturalRepetitionIsNot) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        EXPECT_TRUE(frozen_in(swinging_markers(1e-4, seed)).empty());
        EXPECT_TRUE(frozen_in(written(swinging_markers(1e-5, seed), 1e-3)).empty()) << "rests for 20 samples";
        std::vector<Matrix3Xd> polled = written(swinging_markers(1e-4, seed), 1e-6);
        for (Matrix3Xd& track : polled) freeze(track, 45, 60);
        EXPECT_TRUE(frozen_in(polled).empty());
        std::vector<Matrix3Xd> mounted = written(swinging_markers(1e-5, seed), 1e-4);
        mounted[0] = mounted[0].col(0).replicate(1, mounted[0].cols());
        EXPECT_TRUE(frozen_in(mounted).empty());
        // One limb rests while the others move, and is moved later.
        std::vector<Matrix3Xd> limbs = written(swinging_markers(1e-5, seed, 300), 1e-4);
        Matrix3Xd late = limbs[2].col(0).replicate(1, 300);
        late.rightCols(150) = limbs[2].leftCols(150);
        limbs[2] = late;
        EXPECT_TRUE(frozen_in(limbs).empty());
    }
    EXPECT_TRUE(frozen_in({}).empty());
}

TEST(ZeroGaps, AreZerosFarFromTheTrack) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Matrix3Xd track = swinging_markers(1e-4, seed)[4];
        EXPECT_TRUE(find_zero_gaps(track).empty());
        test::hide(track, 40, 45);
        track.middleCols(45, 20).setZero();
        track.col(100).setZero();
        const std::vector<Index> zeros = find_zero_gaps(track);
        ASSERT_EQ(zeros.size(), 21u);
        EXPECT_EQ(zeros.front(), 45);
        EXPECT_EQ(zeros.back(), 100);
    }
    // A marker at the origin that swings through it, in a file of millimetres.
    Matrix3Xd origin(3, 60);
    for (Index t = 0; t < 60; ++t)
        origin.col(t) = Eigen::Vector3d(0.0, 0.0, 1e-3 * std::round(4.0 * std::sin(0.3 * static_cast<double>(t))));
    ASSERT_TRUE(origin.col(0).isZero(0.0));
    EXPECT_TRUE(find_zero_gaps(origin).empty());
    EXPECT_TRUE(find_zero_gaps(Matrix3Xd::Zero(3, 10)).empty()) << "it may be the origin";
}

}  // namespace
}  // namespace myo::measurement
