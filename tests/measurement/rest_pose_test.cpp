#include "measurement/rest_pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synthetic_take.hpp"

namespace myo::measurement {
namespace {

using test::make_take;
using test::SyntheticTake;

TEST(RestPose, IsTheMeanBeforeTheStart) {
    const Recording recording = make_take({});
    SyntheticTake quiet;
    quiet.noise_m = 1e-15;
    const Recording exact = make_take(quiet);
    const Result<RestPose> pose = rest_pose(recording, 100);
    ASSERT_TRUE(pose);
    for (Eigen::Index i = 0; i < 6; ++i) {
        // Mean of about 100 samples of 5 um.
        EXPECT_LT((pose->positions_m.col(i) - exact.tracks[static_cast<std::size_t>(i)].col(0)).norm(), 2.5e-6);
        EXPECT_NEAR(pose->deviation_m(i), 5e-6, 1e-6);
        EXPECT_GT(pose->samples_used(i), 90);
    }
    EXPECT_EQ(rest_pose_before(recording, 0.9999)->positions_m, pose->positions_m);
}

TEST(RestPose, AStartUpTransientDoesNotBiasIt) {
    Recording recording = make_take({});
    const Result<RestPose> clean = rest_pose(recording, 60);
    for (Eigen::Index t = 0; t < 16; ++t) recording.tracks[4](0, t) += 6e-4 * std::exp(-static_cast<double>(t) / 6.0);
    const Result<RestPose> pose = rest_pose(recording, 60);
    EXPECT_LT((pose->positions_m.col(4) - clean->positions_m.col(4)).norm(), 3e-6);
    EXPECT_LT(pose->samples_used(4), 50);
}

TEST(RestPose, OnlyTheLastSecondCountsWhenTheBodyDrifts) {
    SyntheticTake take;
    take.start_s = 4.0;
    take.drift_m_per_s = 1e-3;
    const Recording recording = make_take(take);
    const Result<RestPose> pose = rest_pose(recording, 400);
    EXPECT_NEAR((pose->positions_m.col(0) - recording.tracks[0].col(399)).norm(), 0.5e-3, 0.05e-3);  // not 2 mm
}

TEST(RestPose, HiddenMarkersAreNamed) {
    Recording recording = make_take({});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    recording.tracks[3].leftCols(120).setConstant(nan);
    recording.tracks[5].leftCols(95).setConstant(nan);
    const Result<RestPose> pose = rest_pose(recording, 100);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->missing, (std::vector<std::string>{"base 1"}));
    EXPECT_TRUE(pose->positions_m.col(3).array().isNaN().all());
    EXPECT_TRUE(pose->positions_m.col(5).allFinite());
    EXPECT_FALSE(rest_pose(recording, 0));
    EXPECT_TRUE(rest_pose_before(recording, -1.0));  // the first sample is all there is
    for (Eigen::Matrix3Xd& track : recording.tracks) track.setConstant(nan);
    EXPECT_THAT(rest_pose(recording, 100).error().what, testing::HasSubstr("no marker is seen"));
}

}  // namespace
}  // namespace myo::measurement
