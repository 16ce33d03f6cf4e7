#include "setup/marker_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "measurement/noise.hpp"
#include "setup/hold_recording.hpp"
#include "setup/setup.hpp"

// Noise of markers: declared, estimated and pooled over trials, never below what rounding makes; poses of held bodies.

namespace myo::setup::marker_noise_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double hidden_m = std::numeric_limits<double>::quiet_NaN();

/// White noise about places, one deviation per marker.
measurement::Recording at_rest(const std::vector<double>& sigma_m, unsigned seed, Index samples = 400) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    measurement::Recording recording;
    recording.rate_Hz = 100.0;
    recording.time_s = Eigen::VectorXd::LinSpaced(samples, 0.0, 0.01 * static_cast<double>(samples - 1));
    for (std::size_t m = 0; m < sigma_m.size(); ++m) {
        recording.labels.push_back(std::string(1, static_cast<char>('a' + m)));
        Matrix3Xd track(3, samples);
        for (double& x : track.reshaped()) x = 0.1 * static_cast<double>(m) + sigma_m[m] * normal(random);
        recording.tracks.push_back(track);
    }
    return recording;
}

/// A setup of so many markers and trials, which say nothing of their noise yet.
Setup plain_setup(std::size_t markers, std::size_t trials) {
    Setup setup;
    for (std::size_t m = 0; m < markers; ++m) setup.marker_names.push_back(std::string(1, static_cast<char>('a' + m)));
    setup.trials.resize(trials);
    for (std::size_t t = 0; t < trials; ++t) setup.trials[t].name = "trial " + std::to_string(t + 1);
    return setup;
}

TEST(MarkerNoise, IsPooledOverTrialsAsSquares) {
    const std::vector<measurement::Recording> recordings{at_rest({1e-5, 4e-5}, 1), at_rest({9e-5, 4e-5}, 2)};
    setup::Setup setup = plain_setup(2, 2);
    set_noise(recordings, setup);
    for (Index m = 0; m < 2; ++m) {
        double squares = 0.0;
        for (const measurement::Recording& recording : recordings) {
            const double own = measurement::estimate_track_noise(recording.tracks[static_cast<std::size_t>(m)]).sigma_m;
            squares += 0.5 * own * own;
        }
        EXPECT_NEAR(setup.noise_m(m), std::sqrt(squares), 1e-12);
    }
    EXPECT_NEAR(setup.noise_m(0), std::sqrt(0.5 * (1e-10 + 81e-10)), 8e-6) << "not the mean of 1 and 9";
    EXPECT_TRUE(setup.warnings.empty());
    EXPECT_NEAR(mean_noise(setup), std::sqrt(0.5 * setup.noise_m.squaredNorm()), 1e-12);
}

/// One quiet marker must not decide a fit alone, and one that is never seen gets the mean of the others.
TEST(MarkerNoise, HasAFloorAndAMean) {
    measurement::Recording recording = at_rest({1e-4, 1e-4, 1e-6, 1e-4}, 3);
    recording.tracks[3].setConstant(hidden_m);
    setup::Setup setup = plain_setup(4, 1);
    set_noise({recording}, setup);
    double squares = 0.0;
    for (std::size_t m = 0; m < 3; ++m)
        squares += std::pow(measurement::estimate_track_noise(recording.tracks[m]).sigma_m, 2) / 3.0;
    const double typical = std::sqrt(squares);
    EXPECT_NEAR(setup.noise_m(3), typical, 1e-12);
    EXPECT_NEAR(setup.noise_m(2), 0.5 * typical, 1e-12);
    EXPECT_GT(setup.noise_m(0), 0.9 * typical);
}

TEST(MarkerNoise, IsAtLeastThatOfTheCoarsestRounding) {
    setup::Setup setup = plain_setup(2, 3);
    const std::vector<measurement::Recording> recordings{at_rest({1e-6, 1e-6}, 4), at_rest({1e-6, 1e-6}, 5),
                                                         at_rest({1e-6, 1e-6}, 6)};
    setup.trials[1].rounding_m = 1e-4;
    setup.trials[2].rounding_m = 1e-5;
    const double rounded = 1e-4 / std::sqrt(12.0);
    set_noise(recordings, setup);
    for (const double noise_m : setup.noise_m) EXPECT_DOUBLE_EQ(noise_m, rounded);
    EXPECT_TRUE(setup.warnings.empty()) << "nothing else was declared";
    // A declaration below it is answered, one above it is taken.
    setup.experiment.markers.noise_m = 2e-5;
    set_noise(recordings, setup);
    EXPECT_DOUBLE_EQ(setup.noise_m(1), rounded);
    ASSERT_EQ(setup.warnings.size(), 1u);
    EXPECT_EQ(setup.warnings[0],
              "markers.noise_m: the numbers of trial trial 2 are rounded to 0.1 mm, which is noise of 0.0289 mm by "
              "itself; it is taken in place of the 0.02 mm declared");
    setup.warnings.clear();
    setup.experiment.markers.noise_m = 3e-5;
    set_noise({}, setup);
    EXPECT_EQ(setup.noise_m, Eigen::Vector2d(3e-5, 3e-5)) << "recordings are not asked";
    EXPECT_TRUE(setup.warnings.empty());
}

TEST(MarkerNoise, IsAssumedWhereNothingTells) {
    setup::Setup setup = plain_setup(2, 1);
    set_noise({at_rest({1e-5, 1e-5}, 7, 8)}, setup);
    EXPECT_EQ(setup.noise_m, Eigen::Vector2d::Constant(marker_noise_policy.assumed_m)) << "eight samples are too few";
    EXPECT_EQ(mean_noise(plain_setup(0, 1)), marker_noise_policy.assumed_m);
}

/// Where all trials hold still, markers get the spread of their poses in common; one motion among them tells noise.
TEST(MarkerNoise, OfPosesIsTheirSpread) {
    const std::vector<measurement::Recording> recordings{at_rest({1e-5, 3e-5}, 8), at_rest({1e-5, 3e-5}, 9)};
    setup::Setup setup = plain_setup(2, 2);
    for (PreparedTrial& trial : setup.trials) trial.hold = true;
    set_noise(recordings, setup);
    double squares = 0.0;
    for (const measurement::Recording& recording : recordings) squares += spread_of_pose(recording).squaredNorm() / 4.0;
    EXPECT_NEAR(setup.noise_m(0), std::sqrt(squares), 1e-15);
    EXPECT_EQ(setup.noise_m(0), setup.noise_m(1));
    setup.trials[1].hold = false;
    set_noise(recordings, setup);
    EXPECT_NE(setup.noise_m(0), setup.noise_m(1));
}

TEST(MadeSamples, AreLeftOutInTheTimeOfTheTrial) {
    experiment::TrialDeclaration declaration;
    declaration.repairs = {{measurement::RepairKind::fill, "a", "", 5.02, 5.04},
                           {measurement::RepairKind::cut, "a", "", 5.06, 5.07},
                           {measurement::RepairKind::smooth, "b", "", 5.00, 5.01, 0.05},
                           {measurement::RepairKind::fill, "gone", "", 5.00, 6.00}};
    PreparedTrial trial;
    trial.measured = at_rest({1e-5, 1e-5}, 10, 12);
    trial.start_s = 5.0;  // in the file
    const measurement::Recording left = without_made_samples(declaration, trial);
    for (Index t = 0; t < 12; ++t) {
        EXPECT_EQ(left.tracks[0].col(t).array().isNaN().all(), t >= 2 && t <= 4) << t;
        EXPECT_EQ(left.tracks[1].col(t).array().isNaN().all(), t <= 1) << t;
    }
    EXPECT_TRUE(trial.measured.tracks[0].allFinite()) << "the recording itself stays";
}

TEST(Poses, HaveMeanAndSpreadOfWhatIsSeen) {
    measurement::Recording recording = at_rest({0.0, 0.0, 0.0}, 11, 4);
    recording.tracks[0].row(1) << 1.0, 2.0, 3.0, hidden_m;
    recording.tracks[0].col(3).setConstant(hidden_m);
    recording.tracks[1].leftCols(3).setConstant(hidden_m);
    recording.tracks[2].setConstant(hidden_m);
    recording.residual_m.assign(3, Eigen::VectorXd::Zero(4));
    const measurement::Recording pose = mean_pose(recording);
    EXPECT_EQ(pose.sample_count(), 1);
    EXPECT_LT((pose.tracks[0].col(0) - Vector3d(0.0, 2.0, 0.0)).norm(), 1e-15);
    EXPECT_LT((pose.tracks[1].col(0) - Vector3d::Constant(0.1)).norm(), 1e-15);
    EXPECT_TRUE(pose.tracks[2].array().isNaN().all());
    EXPECT_TRUE(pose.residual_m.empty());
    const Eigen::VectorXd spread = spread_of_pose(recording);
    // Squares 1 + 0 + 1 of one coordinate, over three coordinates with two degrees of freedom each.
    EXPECT_NEAR(spread(0), std::sqrt(2.0 / 6.0), 1e-15);
    EXPECT_TRUE(std::isnan(spread(1))) << "one sample has no spread";
    EXPECT_TRUE(std::isnan(spread(2)));
}

}  // namespace
}  // namespace myo::setup::marker_noise_test
