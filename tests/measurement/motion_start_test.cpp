#include "measurement/motion_start.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "measurement/recording_edit.hpp"
#include "synthetic_take.hpp"

namespace myo::measurement {
namespace {

using test::make_take;
using test::SyntheticTake;
using testing::HasSubstr;

// Start found minus true start, in samples.
double error_in_samples(const SyntheticTake& take, const Recording& recording,
                        const std::vector<std::string>& labels = {}) {
    const StartOfMotion start = find_motion_start(recording, labels);
    EXPECT_TRUE(start.found) << start.message;
    EXPECT_EQ(start.last_still, start.first_moving - 1);
    EXPECT_LE(start.time_s, recording.time_s(start.first_moving));
    return (start.time_s - take.start_s) * take.rate_Hz;
}

TEST(MotionStart, LiesBetweenTheSamples) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        SyntheticTake take;
        take.seed = seed;
        take.start_s = 1.0 + 0.001 * seed;
        EXPECT_NEAR(error_in_samples(take, make_take(take)), 0.0, 0.2) << seed;
        take.noise_m = 1e-4;
        EXPECT_NEAR(error_in_samples(take, make_take(take)), 0.0, 1.0) << seed;
    }
}

TEST(MotionStart, MoversAreFoundAmongFixedMarkers) {
    const StartOfMotion start = find_motion_start(make_take({}));
    EXPECT_EQ(start.movers, (std::vector<std::string>{"tip 1", "tip 2", "tip 3"}));
    EXPECT_NEAR(start.noise_m, 5e-6, 5e-7);
    EXPECT_THAT(start.message, HasSubstr("motion starts at 1.00"));
}

TEST(MotionStart, SlowAndFastBodiesAtOtherRates) {
    for (const double rate : {25.0, 250.0, 1000.0}) {
        SyntheticTake take;
        take.rate_Hz = rate;
        take.samples = static_cast<int>(3.0 * rate);
        EXPECT_NEAR(error_in_samples(take, make_take(take)) / rate, 0.0, std::max(0.001, 0.5 / rate)) << rate;
        take.frequency_Hz = 0.5;
        EXPECT_NEAR(error_in_samples(take, make_take(take)) / rate, 0.0, 0.03) << rate;
    }
}

TEST(MotionStart, TransientsDriftJumpsGapsAndRepeatsDoNotDisturbIt) {
    const SyntheticTake plain;
    Recording recording = make_take(plain);
    for (Eigen::Index t = 0; t < 15; ++t) recording.tracks[0](1, t) += 6e-4 * (1.0 - static_cast<double>(t) / 15.0);
    EXPECT_NEAR(error_in_samples(plain, recording), 0.0, 0.3) << "transient of a tip marker";
    recording.tracks[1].col(97).array() += 2e-3;
    recording.tracks[4].col(60).array() -= 3e-2;
    EXPECT_NEAR(error_in_samples(plain, recording), 0.0, 0.3) << "jumps of single markers";
    recording.tracks[2].middleCols(92, 14).setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_NEAR(error_in_samples(plain, recording), 0.0, 0.5) << "a marker hidden at the start";
    Recording polled = make_take(plain);
    test::poll(polled);
    EXPECT_NEAR(error_in_samples(plain, polled), 0.0, 1.5) << "repeated rows";
    SyntheticTake drifting;
    drifting.drift_m_per_s = 3e-3;
    EXPECT_NEAR(error_in_samples(drifting, make_take(drifting)), 0.0, 1.0) << "drift of the held body";
}

TEST(MotionStart, OneMarkerAloneDecidesWhenItIsTheOnlyOne) {
    const SyntheticTake take;
    EXPECT_NEAR(error_in_samples(take, make_take(take), {"tip 2"}), 0.0, 0.2);
}

TEST(MotionStart, FewSamplesOfRestAreEnough) {
    SyntheticTake take;
    take.start_s = 0.017;
    EXPECT_NEAR(error_in_samples(take, make_take(take)), 0.0, 1.0);
}

TEST(MotionStart, WhatCannotBeFoundIsSaid) {
    SyntheticTake take;
    take.start_s = -0.005;
    StartOfMotion start = find_motion_start(make_take(take));
    EXPECT_FALSE(start.found);
    EXPECT_EQ(start.time_s, 0.0);
    EXPECT_EQ(start.last_still, -1);
    EXPECT_THAT(start.message, HasSubstr("started by the second sample"));
    take.start_s = 100.0;
    start = find_motion_start(make_take(take));
    EXPECT_FALSE(start.found);
    EXPECT_THAT(start.message, HasSubstr("no marker leaves its rest clearly"));
    EXPECT_THAT(find_motion_start(make_take({}), {"tipp 1"}).message, HasSubstr("no marker 'tipp 1'"));
    EXPECT_THAT(find_motion_start(Recording{}).message, HasSubstr("empty"));
    EXPECT_FALSE(find_motion_start(slice(make_take({}), 0, 1)).found);
    Recording hidden = make_take({});
    for (Eigen::Matrix3Xd& track : hidden.tracks) track.setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(find_motion_start(hidden).found);
}

}  // namespace
}  // namespace myo::measurement
