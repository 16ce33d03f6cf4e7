#include "setup/hold_recording.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace myo::setup {
namespace {

constexpr double hidden = std::numeric_limits<double>::quiet_NaN();

/// Two markers: one that drifts by 2 mm along x, one that is never seen.
measurement::Recording drifting() {
    measurement::Recording recording;
    recording.labels = {"a", "b"};
    recording.time_s = Eigen::VectorXd::LinSpaced(5, 0.0, 2.0);
    Eigen::Matrix3Xd track = Eigen::Matrix3Xd::Zero(3, 5);
    track.row(0) = Eigen::RowVectorXd::LinSpaced(5, 0.099, 0.101);
    track.col(1).setConstant(hidden);
    track.col(3).setConstant(hidden);
    recording.tracks = {track, Eigen::Matrix3Xd::Constant(3, 5, hidden)};
    recording.rate_Hz = 2.0;
    return recording;
}

TEST(HoldRecording, IsTheMeanOfTheVisibleSamples) {
    const measurement::Recording pose = mean_pose(drifting());
    ASSERT_EQ(pose.sample_count(), 1);
    EXPECT_EQ(pose.time_s(0), 0.0);
    EXPECT_NEAR(pose.tracks[0](0, 0), 0.1, 1e-15);
    EXPECT_EQ(pose.tracks[0](1, 0), 0.0);
    EXPECT_TRUE(pose.tracks[1].array().isNaN().all());
    EXPECT_EQ(pose.rate_Hz, 2.0);
}

/// Three samples at -1, 0 and 1 mm: variance 1 mm^2 along one of three axes.
TEST(HoldRecording, SpreadsAsItDrifts) {
    const Eigen::VectorXd spread = spread_of_pose(drifting());
    EXPECT_NEAR(spread(0), 1e-3 / std::sqrt(3.0), 1e-12);
    EXPECT_TRUE(std::isnan(spread(1)));
}

}  // namespace
}  // namespace myo::setup
