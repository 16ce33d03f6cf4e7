#include "experiment/leave_out.hpp"

#include <gtest/gtest.h>

#include <set>

namespace myo::experiment {
namespace {

/// Eleven trials to fit and one to predict.
Experiment twelve_trials() {
    Experiment experiment;
    for (int i = 0; i < 12; ++i) {
        TrialDeclaration trial;
        trial.name = "t" + std::to_string(i);
        trial.role = i == 4 ? TrialRole::validate : TrialRole::fit;
        experiment.trials.push_back(trial);
    }
    return experiment;
}

TEST(LeaveOut, MovesTrialsFromFitToValidate) {
    Experiment experiment = twelve_trials();
    const Result<std::vector<std::string>> left = leave_out(experiment, 3, 1);
    ASSERT_TRUE(left);
    EXPECT_EQ(left->size(), 3u);
    int predicted = 0;
    for (const TrialDeclaration& trial : experiment.trials) predicted += trial.role == TrialRole::validate ? 1 : 0;
    EXPECT_EQ(predicted, 4);
    for (const std::string& name : *left) EXPECT_NE(name, "t4") << "declared to be predicted";
}

TEST(LeaveOut, DrawsBySeedAlone) {
    std::set<std::vector<std::string>> draws;
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 1u, 2u}) {
        Experiment experiment = twelve_trials();
        draws.insert(*leave_out(experiment, 3, seed));
    }
    EXPECT_EQ(draws.size(), 5u);
}

TEST(LeaveOut, LeavesATrialToFit) {
    Experiment experiment = twelve_trials();
    EXPECT_FALSE(leave_out(experiment, 11, 1));
    EXPECT_TRUE(leave_out(experiment, 10, 1));
}

TEST(LeaveOut, SaysThatNoTrialIsToFit) {
    Experiment experiment = twelve_trials();
    for (TrialDeclaration& trial : experiment.trials) trial.role = TrialRole::simulate;
    const Result<std::vector<std::string>> left = leave_out(experiment, 1, 1);
    ASSERT_FALSE(left);
    EXPECT_EQ(left.error().what, "no trial has role = \"fit\", so that none can be left out");
    EXPECT_EQ(left.error().where, "--leave-out");
}

}  // namespace
}  // namespace myo::experiment
