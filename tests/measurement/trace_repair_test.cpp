#include "measurement/trace_repair.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "measurement/gaps.hpp"
#include "measurement/swinging_markers.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using testing::HasSubstr;

/// Five markers of a swinging beam, 100 Hz from 5 s on.
Recording beam(double noise_m, unsigned seed = 1) {
    Recording recording;
    recording.labels = {"m0", "m1", "m2", "m3", "m4"};
    recording.tracks = test::swinging_markers(noise_m, seed);
    recording.time_s = Eigen::VectorXd::LinSpaced(120, 5.0, 6.19);
    return recording;
}

/// Root mean square of the distances in [first, end).
double rms(const Matrix3Xd& a, const Matrix3Xd& b, Index first, Index end) {
    return std::sqrt((a - b).middleCols(first, end - first).colwise().squaredNorm().mean());
}

/// All other samples are those of the original, to the bit.
void expect_unchanged_outside(const Recording& before, const Recording& after, std::size_t marker, Index first,
                              Index end) {
    for (std::size_t m = 0; m < before.tracks.size(); ++m)
        for (Index t = 0; t < before.sample_count(); ++t) {
            if (m == marker && t >= first && t < end) continue;
            EXPECT_EQ(before.tracks[m].col(t), after.tracks[m].col(t)) << m << " " << t;
        }
}

TEST(TraceRepair, CutMakesAGapOfTheSpanWithBothEnds) {
    const Recording before = beam(1e-4);
    Recording cut = before;
    const Result<Index> changed = repair_trace(cut, {RepairKind::cut, "m2", "", 5.3, 5.39, 0.0});
    ASSERT_TRUE(changed) << changed.error().text();
    EXPECT_EQ(*changed, 10);
    for (Index t = 30; t < 40; ++t) EXPECT_FALSE(is_seen(cut.tracks[2], t)) << t;
    expect_unchanged_outside(before, cut, 2, 30, 40);
    EXPECT_FALSE(repair_trace(cut, {RepairKind::cut, "m2", "", 5.32, 5.35, 0.0})) << "nothing is left to cut";
}

TEST(TraceRepair, SwapTwiceIsTheRecordingAgain) {
    const Recording before = beam(1e-4);
    Recording swapped = before;
    const TraceRepair swap{RepairKind::swap, "m1", "m3", 5.5, 5.7, 0.0};
    ASSERT_TRUE(repair_trace(swapped, swap));
    EXPECT_EQ(swapped.tracks[1].col(60), before.tracks[3].col(60));
    EXPECT_EQ(swapped.tracks[3].col(60), before.tracks[1].col(60));
    EXPECT_EQ(swapped.tracks[1].col(49), before.tracks[1].col(49));
    EXPECT_EQ(swapped.tracks[1].col(71), before.tracks[1].col(71));
    ASSERT_TRUE(repair_trace(swapped, swap));
    EXPECT_EQ(swapped.tracks, before.tracks);
}

/// A cubic motion is filled exactly: the polynomial of the fill can follow it.
TEST(TraceRepair, FillIsExactForCubics) {
    Recording recording = beam(0.0);
    for (Index t = 0; t < 120; ++t) {
        const double x = 0.01 * static_cast<double>(t);
        recording.tracks[4].col(t) = Eigen::Vector3d(x * x * x, 1.0 - x, x * x - 0.3 * x);
    }
    const Matrix3Xd truth = recording.tracks[4];
    test::hide(recording.tracks[4], 50, 60);
    const Result<Index> filled = repair_trace(recording, {RepairKind::fill, "m4", "", 5.0, 6.19, 0.0});
    ASSERT_TRUE(filled) << filled.error().text();
    EXPECT_EQ(*filled, 10);
    EXPECT_LT((recording.tracks[4] - truth).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TraceRepair, FillFollowsASwingAndLeavesGapsAtTheEnds) {
    Recording recording = beam(0.0);
    const Matrix3Xd truth = recording.tracks[4];
    test::hide(recording.tracks[4], 70, 75);
    test::hide(recording.tracks[4], 115, 120);
    const Recording gapped = recording;
    ASSERT_TRUE(repair_trace(recording, {RepairKind::fill, "m4", "", 5.0, 6.19, 0.0}));
    Matrix3Xd straight = truth;
    for (Index t = 70; t < 75; ++t) {
        const double w = static_cast<double>(t - 69) / 6.0;
        straight.col(t) = (1.0 - w) * truth.col(69) + w * truth.col(75);
    }
    // 50 ms of a swing whose fast mode has a period of 90 ms: the polynomial follows its curvature, a line does not.
    EXPECT_LT(rms(recording.tracks[4], truth, 70, 75), 0.5 * rms(straight, truth, 70, 75));
    for (Index t = 115; t < 120; ++t) EXPECT_FALSE(is_seen(recording.tracks[4], t));
    // Only what lies in the span is filled.
    Recording part = gapped;
    const Result<Index> two = repair_trace(part, {RepairKind::fill, "m4", "", 5.71, 5.72, 0.0});
    ASSERT_TRUE(two);
    EXPECT_EQ(*two, 2);
    EXPECT_FALSE(is_seen(part.tracks[4], 70));
    EXPECT_FALSE(is_seen(part.tracks[4], 73));
}

/// A cubic through n samples keeps the noise times sqrt(9 / (4 n)) in the middle of the window (Savitzky & Golay).
TEST(TraceRepair, SmoothTakesNoiseAwayAsTheFormulaSays) {
    Recording recording = beam(0.0);
    Recording noisy = beam(3e-4, 2);
    for (Index t = 0; t < 120; ++t) {
        const Eigen::Vector3d noise = noisy.tracks[0].col(t) - recording.tracks[0].col(t);
        noisy.tracks[0].col(t) = noise;  // around a marker at rest
    }
    const Recording before = noisy;
    const Result<Index> smoothed = repair_trace(noisy, {RepairKind::smooth, "m0", "", 5.1, 6.09, 0.2});
    ASSERT_TRUE(smoothed) << smoothed.error().text();
    EXPECT_EQ(*smoothed, 100);
    const Matrix3Xd zero = Matrix3Xd::Zero(3, 120);
    const double kept = rms(noisy.tracks[0], zero, 10, 110) / rms(before.tracks[0], zero, 10, 110);
    EXPECT_NEAR(kept, std::sqrt(9.0 / (4.0 * 21.0)), 0.08);
    expect_unchanged_outside(before, noisy, 0, 10, 110);
}

TEST(TraceRepair, SmoothKeepsCubicsAndGaps) {
    Recording recording = beam(0.0);
    for (Index t = 0; t < 120; ++t) {
        const double x = 0.01 * static_cast<double>(t);
        recording.tracks[4].col(t) = Eigen::Vector3d(x * x * x, 1.0 - x, x * x);
    }
    const Matrix3Xd truth = recording.tracks[4];
    test::hide(recording.tracks[4], 50, 53);
    ASSERT_TRUE(repair_trace(recording, {RepairKind::smooth, "m4", "", 5.0, 6.19, 0.1}));
    for (Index t = 50; t < 53; ++t) EXPECT_FALSE(is_seen(recording.tracks[4], t));
    EXPECT_LT((recording.tracks[4] - truth).leftCols(50).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TraceRepair, RefusesWithOneSentenceAndChangesNothing) {
    const Recording before = beam(1e-4);
    const auto sentence = [&](const TraceRepair& repair) {
        Recording tried = before;
        const Result<Index> result = repair_trace(tried, repair);
        EXPECT_FALSE(result);
        EXPECT_EQ(tried.tracks, before.tracks);
        return result ? std::string() : result.error().what;
    };
    EXPECT_THAT(sentence({RepairKind::cut, "mm2", "", 5.0, 5.1, 0.0}), HasSubstr("no marker \"mm2\"; the closest one"));
    EXPECT_THAT(sentence({RepairKind::swap, "m2", "tail", 5.0, 5.1, 0.0}), HasSubstr("no marker \"tail\""));
    EXPECT_THAT(sentence({RepairKind::swap, "m2", "m2", 5.0, 5.1, 0.0}), HasSubstr("cannot be swapped with itself"));
    EXPECT_THAT(sentence({RepairKind::cut, "m2", "", 0.0, 4.9, 0.0}), HasSubstr("no sample lies from 0 s to 4.9 s"));
    EXPECT_THAT(sentence({RepairKind::fill, "m2", "", 5.0, 5.5, 0.0}), HasSubstr("has no gap"));
    EXPECT_THAT(sentence({RepairKind::smooth, "m2", "", 5.0, 5.5, 0.02}), HasSubstr("holds fewer than 5 samples"));
}

TEST(TraceRepair, IsToldInWords) {
    EXPECT_EQ(repair_words({RepairKind::cut, "tip", "", 1.2, 1.5, 0.0}), "cut \"tip\" from 1.2 s to 1.5 s");
    EXPECT_EQ(repair_words({RepairKind::swap, "a", "b", 1.2, 1.5, 0.0}, -1.0),
              "swapped \"a\" and \"b\" from 0.2 s to "
              "0.5 s");
    EXPECT_EQ(repair_words({RepairKind::smooth, "tip", "", 1.0, 2.0, 0.05}),
              "smoothed \"tip\" from 1 s to 2 s (window 0.05 s)");
}

}  // namespace
}  // namespace myo::measurement
