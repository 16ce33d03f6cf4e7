#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <random>

#include "measurement/noise.hpp"
#include "measurement/registration.hpp"
#include "measurement/robust.hpp"
#include "measurement/smoothing_spline.hpp"
#include "measurement/time_alignment.hpp"
#include "measurement/trace_file.hpp"

// Small tools that searches of faults stand on: medians, splines, delays, rigid motions, names of files.

namespace myo::measurement::curve_tools_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::HasSubstr;

VectorXd list(std::initializer_list<double> values) {
    return Eigen::Map<const VectorXd>(values.begin(), static_cast<Index>(values.size()));
}

TEST(Median, IsTheMiddleOrTheMeanOfTwo) {
    EXPECT_EQ(median(list({3.0})), 3.0);
    EXPECT_EQ(median(list({2.0, 1.0})), 1.5);
    EXPECT_EQ(median(list({5.0, -1.0, 3.0})), 3.0);
    EXPECT_EQ(median(list({4.0, 1.0, 3.0, 2.0})), 2.5);
    EXPECT_EQ(median(list({7.0, 7.0, 7.0, 1.0})), 7.0);
    EXPECT_EQ(median(list({0.0, std::numeric_limits<double>::infinity(), 1.0})), 1.0) << "no outlier moves it";
    EXPECT_DOUBLE_EQ(median_deviation(list({1.0, 2.0, 3.0, 4.0, 100.0}), 3.0), 1.4826);
    EXPECT_DOUBLE_EQ(median_deviation(list({1.0, 2.0, 3.0, 4.0, 100.0}), 0.0), 3.0 * 1.4826);
    EXPECT_EQ(median_deviation(list({2.0, 2.0}), 2.0), 0.0);
}

/// Three quarters of a normal distribution lie below 0.6745 standard deviations: hence the factor.
TEST(Median, DeviationIsThatOfANormalDistribution) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(10.0, 2.0);
    VectorXd values(20001);
    for (double& value : values) value = normal(random);
    EXPECT_NEAR(median(values), 10.0, 0.06);
    EXPECT_NEAR(median_deviation(values, median(values)), 2.0, 0.06);
}

TEST(MeanNoise, LeavesOutWhatWasNotFound) {
    NoiseEstimate three, four, none;
    three.found = four.found = true;
    three.sigma_m = 3.0, four.sigma_m = 4.0, none.sigma_m = 100.0;
    EXPECT_DOUBLE_EQ(mean_noise({three, none, four}), std::sqrt(12.5));
    EXPECT_EQ(mean_noise({none}), 0.0);
    EXPECT_EQ(mean_noise({}), 0.0);
    // Errors of rounding to a step are uniform between minus and plus half of it.
    double squares = 0.0;
    for (int k = 0; k < 1000; ++k) squares += std::pow(0.6 * ((k + 0.5) / 1000.0 - 0.5), 2) / 1000.0;
    EXPECT_NEAR(rounding_deviation(0.6), std::sqrt(squares), 1e-6);
}

QuinticSpline random_spline(Index intervals) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    return {2.0, 0.25, MatrixXd(2, intervals + 5).unaryExpr([&](double) { return place(random); })};
}

TEST(QuinticSpline, HasLinearPrecision) {
    QuinticSpline spline{2.0, 0.25, MatrixXd(2, 9)};
    for (Index i = 0; i < 9; ++i) spline.controls.col(i) << 1.0, static_cast<double>(i);
    EXPECT_EQ(spline.last_s(), 3.0) << "four intervals";
    for (double t = 2.0; t <= 3.0; t += 0.0625) {
        EXPECT_NEAR(spline.at(t)(0), 1.0, 1e-14);
        // The third control stands at the start of the first interval: the middle of what it reaches.
        EXPECT_NEAR(spline.at(t)(1), 2.0 + (t - 2.0) / 0.25, 1e-13);
        EXPECT_NEAR(spline.at(t, 1)(1), 4.0, 1e-12);
        EXPECT_NEAR(spline.at(t, 2)(1), 0.0, 1e-11);
    }
}

TEST(QuinticSpline, DerivativesAreSmoothAcrossIntervals) {
    const QuinticSpline spline = random_spline(6);
    const double h = 1e-5;
    for (double t = 2.03; t < 3.4; t += 0.0712)
        for (const int order : {0, 1}) {
            const VectorXd difference = (spline.at(t + h, order) - spline.at(t - h, order)) / (2.0 * h);
            EXPECT_LT((spline.at(t, order + 1) - difference).norm(), 1e-6 * (1.0 + difference.norm())) << t;
        }
    for (int k = 1; k < 6; ++k)
        for (const int order : {0, 1, 2}) {
            const double border = 2.0 + 0.25 * k;
            EXPECT_LT((spline.at(border - 1e-9, order) - spline.at(border + 1e-9, order)).norm(), 1e-4) << border;
        }
}

TEST(QuinticSpline, IsConstantBeforeAndStraightBehind) {
    const QuinticSpline spline = random_spline(6);
    const VectorXd first = spline.at(2.0), last = spline.at(3.5), slope = spline.at(3.5, 1);
    EXPECT_EQ(spline.at(-7.0), first);
    EXPECT_EQ(spline.at(1.999, 1), VectorXd::Zero(2));
    EXPECT_EQ(spline.at(1.999, 2), VectorXd::Zero(2));
    EXPECT_GT(slope.norm(), 0.01);
    EXPECT_LT((spline.at(5.5) - (last + 2.0 * slope)).norm(), 1e-13);
    EXPECT_EQ(spline.at(5.5, 1), slope);
    EXPECT_EQ(spline.at(5.5, 2), VectorXd::Zero(2));
}

/// Third differences of quadratic functions vanish: whatever its weight, smoothing leaves them.
TEST(SmoothingSpline, LeavesQuadraticsAsTheyAre) {
    const VectorXd times = VectorXd::LinSpaced(25, 1.0, 3.4);
    MatrixXd samples(2, 25);
    const auto value = [](double t) { return Eigen::Vector2d(1.0 + t - 0.5 * t * t, 3.0 * t * t); };
    for (Index t = 0; t < 25; ++t) samples.col(t) = value(times(t));
    const QuinticSpline spline = smoothing_spline(times, samples, 0.0);
    EXPECT_EQ(spline.first_s, 1.0);
    EXPECT_NEAR(spline.last_s(), 3.4, 1e-12);
    for (double t = 1.0; t < 3.4; t += 0.037) {
        EXPECT_LT((spline.at(t) - value(t)).norm(), 1e-7);
        EXPECT_LT((spline.at(t, 1) - Eigen::Vector2d(1.0 - t, 6.0 * t)).norm(), 1e-6);
        EXPECT_LT((spline.at(t, 2) - Eigen::Vector2d(-1.0, 6.0)).norm(), 1e-4);
    }
}

/// A motion without period, so that only one delay fits.
Matrix3Xd wobble(const VectorXd& time_s) {
    Matrix3Xd track(3, time_s.size());
    for (Index i = 0; i < time_s.size(); ++i) {
        const double t = time_s(i);
        track.col(i) << std::sin(3.0 * t) * std::exp(-0.4 * t), 0.5 * std::cos(5.1 * t + 0.3 * t * t), 0.1;
    }
    return track;
}

TEST(TimeAlignment, OfARecordWithItselfIsNothing) {
    const VectorXd times = VectorXd::LinSpaced(101, 0.0, 4.0);
    const auto same = align_in_time(times, {wobble(times)}, times, {wobble(times)});
    ASSERT_TRUE(same);
    EXPECT_EQ(same->delay_s, 0.0);
    EXPECT_NEAR(same->correlation, 1.0, 1e-12);
}

/// Clocks, places and sizes of the two records are of no account but for the delay itself.
TEST(TimeAlignment, FollowsTheClocksAndNothingElse) {
    const VectorXd reference = VectorXd::LinSpaced(81, 0.0, 2.01), recorded = VectorXd::LinSpaced(101, 0.0, 2.5);
    const auto delay = [&](double of_reference, double of_record, double size, double offset) {
        Matrix3Xd seen = size * wobble((recorded.array() - 0.3).max(0.0));  // rests until 0.3 s
        seen.array() += offset;
        const auto found = align_in_time(reference.array() + of_reference, {wobble(reference)},
                                         recorded.array() + of_record, {seen});
        EXPECT_TRUE(found);
        return found ? found->delay_s : 0.0;
    };
    const double plain = delay(0.0, 0.0, 1.0, 0.0);
    EXPECT_NEAR(plain, 0.3, 0.01);
    EXPECT_NEAR(delay(0.0, 5.0, 1.0, 0.0), plain + 5.0, 1e-9);
    EXPECT_NEAR(delay(2.0, 0.0, 1.0, 0.0), plain - 2.0, 1e-9);
    EXPECT_NEAR(delay(0.0, 0.0, 0.01, 0.0), plain, 1e-9);
    EXPECT_NEAR(delay(0.0, 0.0, 1.0, 40.0), plain, 1e-6);
}

TEST(TimeAlignment, SaysWhatIsMissing) {
    const VectorXd eight = VectorXd::LinSpaced(8, 0.0, 1.0), seven = eight.head(7);
    EXPECT_TRUE(align_in_time(eight, {wobble(eight)}, eight, {wobble(eight)}));
    EXPECT_EQ(align_in_time(seven, {wobble(seven)}, eight, {wobble(eight)}).error().what, "too few samples to align");
    EXPECT_EQ(align_in_time(eight, {wobble(eight)}, seven, {wobble(seven)}).error().what, "too few samples to align");
    EXPECT_THAT(align_in_time(eight, {wobble(eight), wobble(eight)}, eight, {wobble(eight)}).error().what,
                HasSubstr("the same markers"));
    EXPECT_THAT(align_in_time(eight, {wobble(eight)}, eight, {Matrix3Xd::Ones(3, 8)}).error().what,
                HasSubstr("nothing moves"));
}

/// A cross with arms of 1 m and of so much [m].
Matrix3Xd cross_of(double width_m) {
    Matrix3Xd points(3, 4);
    points << 1, -1, 0, 0, 0, 0, width_m, -width_m, 0, 0, 0, 0;
    return points;
}

TEST(Registration, NeedsAWidthOfATenThousandthOfTheLength) {
    EXPECT_TRUE(rigid_registration(cross_of(1.1e-4), cross_of(1.1e-4)));
    EXPECT_FALSE(rigid_registration(cross_of(0.9e-4), cross_of(0.9e-4)));
    EXPECT_FALSE(rigid_registration(cross_of(1.0), cross_of(0.9e-4))) << "neither side may be a line";
}

TEST(Registration, OfWeightsOnlyTheirRatiosCount) {
    Matrix3Xd from(3, 5);
    from << 0.1, -0.2, 0.3, 0.0, 0.5, 0.0, 0.4, -0.1, 0.2, 0.3, 0.2, 0.0, 0.1, -0.3, 0.4;
    Matrix3Xd to = RigidMotion{small_rotation({0.3, -0.8, 1.2}), {1.0, 2.0, 3.0}}.apply_all(from);
    to.col(0).x() += 0.02, to.col(3).y() -= 0.03, to.col(4).z() += 1.0;
    const VectorXd weights = list({1.0, 2.0, 3.0, 4.0, 0.0});
    const auto all = rigid_registration(from, to, weights), scaled = rigid_registration(from, to, 1e3 * weights),
               fewer = rigid_registration(from.leftCols(4), to.leftCols(4), weights.head(4));
    ASSERT_TRUE(all && scaled && fewer);
    EXPECT_LT((all->motion.rotation - scaled->motion.rotation).norm(), 1e-14);
    EXPECT_LT((all->motion.rotation - fewer->motion.rotation).norm(), 1e-14) << "without weight, without effect";
    EXPECT_NEAR(all->rms_m, fewer->rms_m, 1e-15);
    EXPECT_GT(all->rms_m, 1e-3);
    EXPECT_NEAR(all->distance_m(4), 1.0, 0.1) << "but what is left of it is told";
    EXPECT_FALSE(rigid_registration(from, to, list({1.0, 2.0, 3.0, 4.0, -1e-9})));
}

TEST(RotationAngle, ReachesHalfATurn) {
    EXPECT_EQ(rotation_angle(Eigen::Matrix3d::Identity()), 0.0);
    EXPECT_EQ(rotation_angle(Vector3d(1, -1, -1).asDiagonal()), std::numbers::pi);
    EXPECT_NEAR(rotation_angle(small_rotation({0.0, 0.0, std::numbers::pi + 0.1})), std::numbers::pi - 0.1, 1e-14)
        << "the shorter way";
}

TEST(TraceFile, EndingsInAnyCase) {
    for (const char* file : {"take.csv", "TAKE.CSV", "folder/a.b.c3d", "x.TrC", "x.tsv"})
        EXPECT_TRUE(has_trace_ending(file)) << file;
    for (const char* file : {"csv", "take.csv.png", "take", "", ".csv/take"})
        EXPECT_FALSE(has_trace_ending(file)) << file;
    EXPECT_EQ(first_line("\n \t\r\n  x y \r\nz"), "  x y ");
    EXPECT_EQ(first_line("\n\n"), "");
}

}  // namespace
}  // namespace myo::measurement::curve_tools_test
