#include "measurement/noise.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "synthetic_take.hpp"

namespace myo::measurement {
namespace {

using test::make_take;
using test::SyntheticTake;

// Sigma relative to the truth: mean over markers and seeds, the worst marker, and the worst take (all markers
// together).
struct Recovery {
    double mean = 0.0;
    double worst = 0.0;
    double worst_take = 0.0;
};

template <class Change>
Recovery recovery(SyntheticTake take, const Change& change) {
    Recovery result;
    int count = 0;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        take.seed = seed;
        Recording recording = make_take(take);
        change(recording);
        const std::vector<NoiseEstimate> estimates = estimate_noise(recording);
        result.worst_take = std::max(result.worst_take, std::abs(mean_noise(estimates) / take.noise_m - 1.0));
        for (const NoiseEstimate& estimate : estimates) {
            EXPECT_TRUE(estimate.found);
            const double ratio = estimate.sigma_m / take.noise_m;
            result.mean += ratio;
            result.worst = std::max(result.worst, std::abs(ratio - 1.0));
            ++count;
        }
    }
    result.mean /= count;
    return result;
}

const auto unchanged = [](Recording&) {};

TEST(Noise, IsFoundWithinATenthBesideVibration) {
    for (const double sigma : {5e-6, 1e-4}) {
        SyntheticTake take;
        take.noise_m = sigma;
        const Recovery result = recovery(take, unchanged);
        EXPECT_NEAR(result.mean, 1.0, 0.02) << sigma;
        EXPECT_LT(result.worst_take, 0.06) << sigma;
        EXPECT_LT(result.worst, 0.12) << sigma;  // of 48 markers with about 350 free differences each: 2.7 deviations
    }
}

TEST(Noise, IsFoundWithGaps) {
    const Recovery result = recovery(SyntheticTake{}, [](Recording& recording) {
        for (Eigen::Matrix3Xd& track : recording.tracks) {
            for (Eigen::Index t = 40; t + 12 < track.cols(); t += 70)
                track.middleCols(t, 12).setConstant(std::numeric_limits<double>::quiet_NaN());
        }
    });
    EXPECT_NEAR(result.mean, 1.0, 0.03);
    EXPECT_LT(result.worst_take, 0.1);
    EXPECT_LT(result.worst, 0.18);
}

TEST(Noise, RepeatedRowsDoNotFoolIt) {
    const Recovery result = recovery(SyntheticTake{}, test::poll);
    EXPECT_NEAR(result.mean, 1.0, 0.05);
    EXPECT_LT(result.worst_take, 0.1);
    EXPECT_LT(result.worst, 0.25);  // a fifth of the samples is gone, and the rest is not evenly spaced
}

TEST(Noise, RoundingAddsItsVariance) {
    SyntheticTake take;
    take.noise_m = 1e-6;
    for (const double step : {1e-6, 2e-6}) {
        const Recovery result = recovery(take, [&](Recording& recording) { test::quantise(recording, step); });
        EXPECT_NEAR(result.mean, std::sqrt(1.0 + step * step / 12.0 / 1e-12), 0.04) << step;
    }
    // Noise far below the step of the file: the rounding error remains.
    take.noise_m = 1e-9;
    Recording coarse = make_take(take);
    test::quantise(coarse, 1e-4);
    EXPECT_NEAR(estimate_noise(coarse)[0].sigma_m, 1e-4 / std::sqrt(12.0), 3e-6);
    EXPECT_NEAR(estimate_noise(coarse)[0].quantum_m, 1e-4, 1e-9);
}

TEST(Noise, RoundingOfAFileIsSeen) {
    SyntheticTake take;
    take.noise_m = 1e-4;
    for (const double step : {1e-6, 1e-5, 5e-5, 2e-4, 1e-3, 5e-3}) {
        Recording coarse = make_take(take);
        test::quantise(coarse, step);
        coarse.tracks[0].col(5).setConstant(std::numeric_limits<double>::quiet_NaN());
        EXPECT_NEAR(rounding_step(coarse.tracks), step, 1e-9 * step) << step;
        coarse.tracks[0](1, 3) += 0.1 * step;
        EXPECT_LT(rounding_step(coarse.tracks), 0.2 * step) << step << ": one number is finer";
    }
    EXPECT_EQ(rounding_step(make_take(take).tracks), 0.0);
    EXPECT_EQ(rounding_step({Eigen::Matrix3Xd::Constant(3, 100, 0.25)}), 0.0) << "one number alone tells nothing";
    EXPECT_EQ(rounding_step({}), 0.0);
}

TEST(Noise, JumpsOfAMarkerAreNotNoise) {
    const Recovery result = recovery(SyntheticTake{}, [](Recording& recording) {
        for (Eigen::Matrix3Xd& track : recording.tracks) {
            for (Eigen::Index t = 30; t < track.cols(); t += 83) track.col(t).array() += 1e-3;
        }
    });
    EXPECT_LT(result.worst_take, 0.1);
    EXPECT_LT(result.worst, 0.15);
}

TEST(Noise, TooFewSamplesAreSaidToBe) {
    Recording recording = make_take({});
    recording.tracks[0].rightCols(490).setConstant(std::numeric_limits<double>::quiet_NaN());
    const std::vector<NoiseEstimate> estimates = estimate_noise(recording);
    EXPECT_FALSE(estimates[0].found);
    EXPECT_EQ(estimates[0].sigma_m, 0.0);
    EXPECT_TRUE(estimates[1].found);
    EXPECT_GT(mean_noise(estimates), 4e-6);
    EXPECT_EQ(estimate_track_noise(Eigen::Matrix3Xd(3, 0)).found, false);
    const NoiseEstimate constant = estimate_track_noise(Eigen::Matrix3Xd::Ones(3, 100));
    EXPECT_EQ(constant.sigma_m, 0.0);
}

}  // namespace
}  // namespace myo::measurement
