#include "measurement/recording_edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "measurement/gaps.hpp"
#include "test_files.hpp"

namespace myo::measurement {
namespace {

TEST(RecordingEdit, TransformAndItsInverseAreTheIdentityAndKeepGaps) {
    const Recording original = test::random_recording(4, 30, 1, true);
    const RigidMotion motion{small_rotation({0.4, -1.0, 0.3}), {1.0, 2.0, 3.0}};
    const Recording moved = transform(original, motion);
    EXPECT_GT(test::largest_difference(original, moved), 1.0);
    EXPECT_LT(test::largest_difference(original, transform(moved, motion.inverse())), 1e-14);
    EXPECT_LT((moved.tracks[2].col(0) - motion.apply(original.tracks[2].col(0))).norm(), 1e-15);
}

TEST(RecordingEdit, SlicesAndShifts) {
    Recording original = test::random_recording(2, 30, 2);
    original.residual_m.assign(2, Eigen::VectorXd::LinSpaced(30, 0.0, 29.0));
    const Recording part = slice(original, 5, 12);
    EXPECT_EQ(part.sample_count(), 7);
    EXPECT_EQ(part.time_s(0), original.time_s(5));
    EXPECT_EQ(part.tracks[1].col(6), original.tracks[1].col(11));
    EXPECT_EQ(part.residual_m[0](0), 5.0);
    EXPECT_EQ(slice_time(original, original.time_s(5), original.time_s(11)).tracks[0], part.tracks[0]);
    EXPECT_EQ(slice_time(original, 5.0, 4.0).sample_count(), 0);
    EXPECT_NEAR(shift_time(original, -0.05).time_s(5), 0.0, 1e-15);
}

TEST(RecordingEdit, SelectsAndRenames) {
    const Recording original = test::random_recording(3, 4, 3);
    const Result<Recording> chosen = select_labels(original, {"marker 3", "marker 1"}, {"tip", "base"});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->labels, (std::vector<std::string>{"tip", "base"}));
    EXPECT_EQ(chosen->tracks[0], original.tracks[2]);
    EXPECT_THAT(select_labels(original, {"marker3"}).error().what, testing::HasSubstr("closest one is 'marker"));
}

TEST(Gaps, EveryRunOfOccludedSamplesIsListed) {
    Recording recording = test::random_recording(2, 10, 4);
    for (const Eigen::Index t : {0, 1, 4, 9})
        recording.tracks[1].col(t).setConstant(std::numeric_limits<double>::quiet_NaN());
    const std::vector<MarkerGaps> gaps = gap_map(recording);
    EXPECT_TRUE(gaps[0].gaps.empty());
    EXPECT_EQ(gaps[0].occluded_fraction, 0.0);
    ASSERT_EQ(gaps[1].gaps.size(), 3U);
    EXPECT_EQ(gaps[1].gaps[0].last, 1);
    EXPECT_EQ(gaps[1].gaps[1].first, 4);
    EXPECT_EQ(gaps[1].gaps[2].last, 9);
    EXPECT_EQ(gaps[1].occluded_samples, 4);
    EXPECT_DOUBLE_EQ(gaps[1].occluded_fraction, 0.4);
}

TEST(Gaps, ARepeatIsASampleInWhichNothingIsNew) {
    Recording recording = test::random_recording(2, 8, 5);
    for (Eigen::Matrix3Xd& track : recording.tracks) track.col(3) = track.col(2);
    recording.tracks[0].col(6) = recording.tracks[0].col(5);  // the other marker moved
    EXPECT_EQ(repeated_samples(recording), (std::vector<Eigen::Index>{3}));
    for (const Eigen::Index t : {2, 3})
        recording.tracks[1].col(t).setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(repeated_samples(recording), (std::vector<Eigen::Index>{3}));  // gap on gap repeats as well
    for (const Eigen::Index t : {2, 3})
        recording.tracks[0].col(t).setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(repeated_samples(recording).empty());  // nothing seen is not a repeat
}

}  // namespace
}  // namespace myo::measurement
