#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "diagnosis/fit/fit_data.hpp"
#include "diagnosis/fit/sensor_rows.hpp"
#include "diagnosis/search/beginning_context.hpp"

// Compared samples and readings of hand-made trials, and their order.

namespace myo::diagnosis::compared_samples_test {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

const double nan_value = std::numeric_limits<double>::quiet_NaN();

/// Two markers in trials of four and two samples. The first sample of the first trial is not compared, the second
/// marker is not seen in its third, nor in the second trial.
setup::Setup two_trials() {
    setup::Setup setup;
    setup.marker_names = {"a", "b"};
    setup.noise_m = Eigen::Vector2d(1e-4, 3e-4);
    setup.trials.resize(2);
    for (const std::size_t t : {0u, 1u}) {
        measurement::Recording& measured = setup.trials[t].measured;
        const int samples = t == 0 ? 4 : 2;
        measured.time_s = VectorXd::LinSpaced(samples, 0.0, 0.1 * (samples - 1));
        measured.tracks.assign(2, Matrix3Xd::Zero(3, samples));
    }
    setup.trials[0].first_sample = 1;
    setup.trials[0].measured.tracks[1](1, 2) = nan_value;
    setup.trials[1].measured.tracks[1].setConstant(nan_value);
    return setup;
}

/// Prediction whose residual is 1000 trial + 100 marker + 10 axis + sample, in noise levels.
prediction::TrialPrediction numbered(const setup::Setup& setup, std::size_t trial) {
    prediction::TrialPrediction made;
    for (std::size_t m = 0; m < 2; ++m) {
        Matrix3Xd numbers(3, setup.trials[trial].measured.sample_count());
        for (int axis = 0; axis < 3; ++axis)
            for (int s = 0; s < numbers.cols(); ++s)
                numbers(axis, s) = static_cast<double>(1000 * trial + 100 * m) + 10.0 * axis + s;
        made.residual_m.emplace_back(setup.noise_m(static_cast<Eigen::Index>(m)) * numbers);
    }
    return made;
}

TEST(ComparedSamples, FollowTrialMarkerAxisAndTime) {
    const setup::Setup setup = two_trials();
    const FitData data = fit_data(setup, {1, 0});
    ASSERT_TRUE(statistics::is_consistent(data.layout));
    EXPECT_EQ(data.layout.series.size(), 9u) << "none of a marker that was never seen";
    VectorXd expected(21);
    expected << 1000, 1001, 1010, 1011, 1020, 1021,  // trial, marker, axis, sample
        1, 2, 3, 11, 12, 13, 21, 22, 23,             //
        101, 103, 111, 113, 121, 123;
    const VectorXd found = flat_residual(data, {numbered(setup, 1), numbered(setup, 0)});
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_LT((found - expected).norm(), 1e-9);
    EXPECT_EQ(data.noise_m(14), 1e-4);
    EXPECT_EQ(data.noise_m(15), 3e-4);
    EXPECT_EQ(data.layout.sample[16], 3);
    EXPECT_NEAR(data.layout.time_s[16], 0.3, 1e-15);
    // Trial 1 has six entries, trial 0 fifteen: the mean counts, and the number of the trial is given.
    VectorXd residual = VectorXd::Ones(21);
    residual.head(6).setConstant(1.01);
    EXPECT_EQ(worst_trial(data, residual), 1u);
    residual.head(6).setConstant(0.99);
    EXPECT_EQ(worst_trial(data, residual), 0u);
}

TEST(ComparedSamples, AreNoneWithoutTrials) {
    const FitData data = fit_data(two_trials(), {});
    EXPECT_EQ(data.layout.size(), 0);
    EXPECT_EQ(data.noise_m.size(), 0);
    EXPECT_EQ(flat_residual(data, {}).size(), 0);
    EXPECT_EQ(flat_rms_m(data, {}), 0.0);
}

/// A noise of 0.3 and 5 % of a reading of 8 are 0.5 together.
TEST(SensorRows, FollowTrialSeriesAndReading) {
    setup::Setup setup = two_trials();
    setup::SensorSeries series;
    series.noise = 0.3;
    series.values = VectorXd::Constant(1, 8.0);
    setup.trials[1].sensors = {series};
    series.values = Eigen::Vector2d(8.0, 0.0);
    setup.trials[0].sensors = {series, setup.trials[1].sensors[0]};
    std::vector<prediction::TrialPrediction> runs(2);  // trials 1 and 0
    const auto one = [](double value) { return VectorXd(VectorXd::Constant(1, value)); };
    runs[0].sensor_residuals = {one(-2.0)};
    runs[1].sensor_residuals = {Eigen::Vector2d(1.0, 3.0), one(nan_value)};
    runs[0].sensor_tangents = {{one(9.0)}, {one(4.0)}};
    runs[1].sensor_tangents = {{Eigen::Vector2d(9.0, 9.0), one(9.0)}, {Eigen::Vector2d(5.0, 6.0), one(7.0)}};
    const VectorXd rows = sensor_rows(setup, {1, 0}, runs, DeclaredFitPolicy{});
    ASSERT_EQ(rows.size(), 4);
    EXPECT_LT((rows - Eigen::Vector4d(-4.0, 2.0, 10.0, 0.0)).norm(), 1e-12) << rows.transpose();
    const VectorXd slope = sensor_slope(setup, {1, 0}, runs, 1, DeclaredFitPolicy{});
    EXPECT_LT((slope - Eigen::Vector4d(8.0, 10.0, 20.0, 14.0)).norm(), 1e-12) << slope.transpose();
    EXPECT_EQ(sensor_rows(setup, {}, {}, DeclaredFitPolicy{}).size(), 0);
}

/// A trial of 20 samples from `first` on, whose squared residual is the number of the sample: that of n samples from
/// the first one has the mean first + (n - 1) / 2.
DiagnosisContext counting(Eigen::Index first) {
    DiagnosisContext context;
    context.setup.trials.resize(1);
    context.setup.trials[0].measured.time_s = VectorXd::LinSpaced(20, 0.0, 0.19);
    context.setup.trials[0].first_sample = first;
    context.data.trials = {0};
    context.declared.fit.predictions.resize(1);
    context.declared.fit.residual.resize(20 - first);
    for (Eigen::Index s = first; s < 20; ++s) {
        context.data.layout.sample.push_back(static_cast<int>(s));
        context.data.layout.time_s.push_back(0.01 * static_cast<double>(s));
        context.declared.fit.residual(s - first) = std::sqrt(static_cast<double>(s));
    }
    context.data.layout.series = {{0, 0, 0, 0, 20 - first}};
    return context;
}

TEST(Beginning, IsAShareOfTheComparedSamples) {
    const auto samples = [](const DiagnosisContext& context, double share) {
        const double square = std::pow(residual_in_beginnings(context, share), 2);
        return 1.0 + 2.0 * (square - static_cast<double>(context.setup.trials[0].first_sample));
    };
    EXPECT_NEAR(samples(counting(0), 0.5), 10.0, 1e-9);
    EXPECT_NEAR(samples(counting(0), 0.51), 11.0, 1e-9) << "rounded up";
    EXPECT_NEAR(samples(counting(0), 0.1), BeginningPolicy{}.min_samples, 1e-9);
    EXPECT_NEAR(samples(counting(4), 0.75), 12.0, 1e-9) << "of sixteen";
    EXPECT_NEAR(samples(counting(4), 2.0), 16.0, 1e-9) << "no more than there are";
    DiagnosisContext pose = counting(0);
    pose.setup.trials[0].hold = true;
    EXPECT_NEAR(samples(pose, 0.5), 20.0, 1e-9) << "a pose is compared as a whole";
    pose.data.layout = {};
    EXPECT_EQ(residual_in_beginnings(pose, 0.5), 0.0);
}

}  // namespace
}  // namespace myo::diagnosis::compared_samples_test
