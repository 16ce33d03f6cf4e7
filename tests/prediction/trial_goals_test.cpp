#include "prediction/trial_goals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "prediction/trial_target.hpp"
#include "support/swung_beam.hpp"

namespace myo::prediction {
namespace {

using Eigen::Vector3d;

/// The swung beam, 0.1 s long, with these goals.
setup::Setup beam_with(const test::Folder& folder, const std::vector<experiment::GoalDeclaration>& goals) {
    setup::Setup setup = with_one_trial(test::swung_beam(folder, 0.1), 0);
    setup.experiment.trials[0].goals = goals;
    return setup;
}

experiment::GoalDeclaration place(const std::string& marker, const Vector3d& place_m, double time_s) {
    experiment::GoalDeclaration goal;
    goal.marker = marker;
    goal.times_s = Eigen::VectorXd::Constant(1, time_s);
    goal.places_m = place_m;
    return goal;
}

TEST(TrialGoals, BecomeTheTargetInPlaceOfTheRecording) {
    const test::Folder folder("goals_target");
    experiment::GoalDeclaration held = place("middle", {0.05, 0.015, 0.02}, 0.0);
    held.times_s = Eigen::Vector2d(0.055, 0.095);
    held.places_m = held.places_m.replicate(1, 2).eval();
    held.weight = 3.0;
    held.axes = {false, false, true};
    const Result<setup::Setup> setup = with_goals(
        beam_with(folder, {place("tip_low", {0.09, 0.015, -0.01}, 0.07), held}));
    ASSERT_TRUE(setup) << setup.error().text();
    EXPECT_TRUE(follows_goals(*setup));
    const inverse::MarkerTarget target = trial_target(*setup, 0, 1e9);
    ASSERT_EQ(target.positions_m.size(), 4u);
    EXPECT_EQ(target.times_s.size(), 13) << "eleven samples, and the two ends of the span";
    // Samples at 55, 60, 70, 80, 90 and 95 ms in one coordinate, and one place.
    EXPECT_EQ(target.coordinates(), 6 + 3);
    const auto& z = target.positions_m[3];
    const std::vector<Eigen::Matrix3Xd> shares = inverse::shares_of_coordinates(target);
    double of_place = 0.0, of_held = 0.0;
    for (Eigen::Index t = 0; t < target.times_s.size(); ++t) {
        of_place += shares[2].col(t).sum();
        of_held += shares[3].col(t).sum();
        const bool within = target.times_s(t) >= 0.055 && target.times_s(t) <= 0.095;
        EXPECT_EQ(std::isfinite(z(2, t)), within) << target.times_s(t);
        EXPECT_TRUE(std::isnan(z(0, t)));
        EXPECT_EQ(std::isfinite(target.positions_m[2](0, t)), std::abs(target.times_s(t) - 0.07) < 1e-12);
    }
    // The place counts in three coordinates, the span in one with three times the weight.
    EXPECT_NEAR(of_place, 0.5, 1e-12);
    EXPECT_NEAR(of_held, 0.5, 1e-12);
}

TEST(TrialGoals, EndTheRunsThatAreMadeForThem) {
    const test::Folder folder("goals_end");
    const setup::Setup recorded = beam_with(folder, {});
    EXPECT_EQ(until_last_goal(recorded).trials[0].options.end_s, recorded.trials[0].options.end_s) << "no goals";
    const Result<setup::Setup> setup = with_goals(beam_with(folder, {place("tip_low", {0.09, 0.015, -0.01}, 0.045)}));
    ASSERT_TRUE(setup) << setup.error().text();
    ASSERT_GT(setup->trials[0].options.end_s, 0.1);
    const setup::Setup cut = until_last_goal(*setup);
    const setup::PreparedTrial& trial = cut.trials[0];
    EXPECT_DOUBLE_EQ(trial.options.end_s, 0.045);
    EXPECT_EQ(trial.measured.time_s.size(), 6) << "samples up to 40 ms, and the goal";
    const inverse::MarkerTarget whole = trial_target(*setup, 0, 1e9), target = trial_target(cut, 0, 1e9);
    EXPECT_EQ(target.coordinates(), whole.coordinates());
    for (std::size_t m = 0; m < target.weights.size(); ++m) EXPECT_EQ(target.weights[m].cols(), 6);
}

TEST(TrialGoals, OfATrialWithoutGoalsAreItsRecording) {
    const test::Folder folder("goals_none");
    const setup::Setup beam = beam_with(folder, {});
    const Result<setup::Setup> setup = with_goals(beam);
    ASSERT_TRUE(setup);
    EXPECT_FALSE(follows_goals(*setup));
    EXPECT_EQ(setup->trials[0].measured.tracks[0], beam.trials[0].measured.tracks[0]);
    EXPECT_EQ(without_goals(*setup).trials[0].role, experiment::TrialRole::fit);
}

TEST(TrialGoals, AreNoMeasurements) {
    const test::Folder folder("goals_checked");
    const Result<setup::Setup> setup = with_goals(beam_with(folder, {place("tip_low", {0.09, 0.015, -0.01}, 0.07)}));
    ASSERT_TRUE(setup);
    const setup::Setup checked = without_goals(*setup);
    EXPECT_EQ(checked.trials[0].role, experiment::TrialRole::simulate);
    EXPECT_EQ(checked.experiment.trials[0].role, experiment::TrialRole::simulate);
    for (const Eigen::Matrix3Xd& track : checked.trials[0].measured.tracks) EXPECT_TRUE(track.array().isNaN().all());
}

TEST(TrialGoals, AfterTheEndOfTheRecordingAreRefused) {
    const test::Folder folder("goals_late");
    const Result<setup::Setup> setup = with_goals(beam_with(folder, {place("tip_low", {0.09, 0.015, -0.01}, 0.7)}));
    ASSERT_FALSE(setup);
    EXPECT_THAT(setup.error().what, testing::HasSubstr("trial[0].goal[0]: 0.7 s lies after the end of trial swing"));
}

}  // namespace
}  // namespace myo::prediction
