#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/new_trial.hpp"
#include "experiment/read_experiment.hpp"
#include "support/good_experiment.hpp"

// Goals of trials: places of markers at times, instead of a recording.

namespace myo::experiment {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using namespace testing_support;

// Functions: good_toml is made at the start of the program, in no order with constants of this file.
std::string planned() {
    return good_toml + "\n[[trial]]\nname = \"planned\"\nrole = \"simulate\"\nduration_s = 1.0\nstart = \"straight\"\n";
}
std::string held_toml() { return good_toml + "\n[[trial]]\nname = \"held\"\nrole = \"simulate\"\nhold = true\n"; }

/// Writes the experiment with goals of its last trial, and the path of the tip.
void write_goals(const Folder& folder, const std::string& toml) {
    write_files(folder, toml);
    folder.write("goal.csv",
                 "time_s,tip_x_mm,tip_y_mm,tip_z_mm,side_x_mm,side_y_mm,side_z_mm\n"
                 "0.2,100,0,24,nan,nan,nan\n0.6,98,0,20,50,36,6\n");
}

/// Goals of the last trial.
std::vector<GoalDeclaration> goals_of(const std::string& toml) {
    const Folder folder("goals_read");
    write_goals(folder, toml);
    const Result<Experiment> read = read_experiment(folder.path());
    EXPECT_TRUE(read) << read.error().text();
    return read ? read->trials.back().goals : std::vector<GoalDeclaration>{};
}

TEST(TrialGoals, AreAPlaceAtATimeOrUntilAnother) {
    const std::vector<GoalDeclaration> goals = goals_of(
        planned() +
        "[[trial.goal]]\nmarker = \"tip\"\nplace_m = [0.09, 0.0, 0.01]\ntime_s = 0.5\n"
        "[[trial.goal]]\nmarker = \"tip\"\nplace_m = [0.08, 0.0, 0.0]\ntime_s = 0.8\nuntil_s = 1.0\n"
        "weight = 2.5\naxes = [\"z\", \"x\"]\n");
    ASSERT_EQ(goals.size(), 2u);
    EXPECT_EQ(goals[0].marker, "tip");
    EXPECT_EQ(goals[0].times_s, Eigen::VectorXd::Constant(1, 0.5));
    EXPECT_EQ(goals[0].places_m.col(0), Eigen::Vector3d(0.09, 0.0, 0.01));
    EXPECT_EQ(goals[0].weight, 1.0);
    EXPECT_EQ(goals[0].axes, (std::array<bool, 3>{true, true, true}));
    EXPECT_FALSE(goals[0].is_path);
    EXPECT_EQ(goals[1].times_s, Eigen::Vector2d(0.8, 1.0));
    EXPECT_EQ(place_at(goals[1], 0.93), Eigen::Vector3d(0.08, 0.0, 0.0));
    EXPECT_EQ(goals[1].weight, 2.5);
    EXPECT_EQ(goals[1].axes, (std::array<bool, 3>{true, false, true}));
}

TEST(TrialGoals, ArePathsFromAFileOrFromLists) {
    const std::vector<GoalDeclaration> goals = goals_of(
        planned() +
        "[[trial.goal]]\nmarker = \"tip\"\npath = \"goal.csv\"\n"
        "[[trial.goal]]\nmarker = \"side\"\ntimes_s = [0.0, 0.5]\nplaces_m = [[0.05, 0.036, 0.006], [0.05, 0.036, "
        "0.0]]\n");
    ASSERT_EQ(goals.size(), 2u);
    ASSERT_TRUE(goals[0].is_path && goals[0].file);
    EXPECT_LT((place_at(goals[0], 0.4) - Eigen::Vector3d(0.099, 0.0, 0.022)).norm(), 1e-12);
    EXPECT_LT((place_at(goals[0], 0.1) - Eigen::Vector3d(0.1, 0.0, 0.024)).norm(), 1e-12) << "before: the first";
    EXPECT_LT((place_at(goals[0], 0.9) - Eigen::Vector3d(0.098, 0.0, 0.02)).norm(), 1e-12) << "after: the last";
    EXPECT_TRUE(goals[1].is_path && !goals[1].file);
    EXPECT_NEAR(place_at(goals[1], 0.25).z(), 0.003, 1e-12);
}

TEST(TrialGoals, StandBesideARecordingAndInAHold) {
    const std::string goal = "[[trial.goal]]\nmarker = \"tip\"\nplace_m = [0.1, 0.0, 0.0]\n";
    EXPECT_EQ(goals_of(good_toml + goal + "time_s = 3.0\n").size(), 1u);
    const std::vector<GoalDeclaration> goals = goals_of(held_toml() + goal);
    ASSERT_EQ(goals.size(), 1u);
    EXPECT_EQ(goals[0].times_s, Eigen::VectorXd::Zero(1));
}

TEST(TrialGoals, StayInACopyOfTheExperiment) {
    const Folder folder("goals_copied");
    write_goals(folder, planned() + "[[trial.goal]]\nmarker = \"tip\"\npath = \"goal.csv\"\n");
    const auto copy = folder.path().parent_path() / (folder.path().filename().string() + "_copy");
    ASSERT_TRUE(copy_experiment(folder.path(), copy));
    const Result<Experiment> read = read_experiment(copy);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->trials.back().goals.size(), 1u);
    EXPECT_EQ(read->trials.back().goals[0].file, copy / "goal.csv");
    std::filesystem::remove_all(copy);
}

/// Keys of a goal that are refused.
struct BadGoal {
    std::string trial, keys;  // the trial, and the keys after those of the first goal
    std::string line, key, word;
};

void PrintTo(const BadGoal& bad, std::ostream* out) { *out << bad.keys; }

class BadGoals : public testing::TestWithParam<BadGoal> {};

TEST_P(BadGoals, AreReportedWithKeyAndLine) {
    const BadGoal& bad = GetParam();
    const Folder folder("bad_goal");
    const std::string toml = bad.trial + "[[trial.goal]]\n" + bad.keys;
    write_goals(folder, toml);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().where,
              (folder.path() / "experiment.toml").string() + ":" + std::to_string(line_of(toml, bad.line)))
        << read.error().what;
    EXPECT_THAT(read.error().what,
                StartsWith("trial[3].goal[" + std::string(bad.key.substr(0, 1)) + "]" + bad.key.substr(1)));
    EXPECT_THAT(read.error().what, HasSubstr(bad.word));
}

const std::string tip = "marker = \"tip\"\n", here = "place_m = [0.1, 0.0, 0.0]\n";

INSTANTIATE_TEST_SUITE_P(
    Keys, BadGoals,
    testing::Values(
        BadGoal{planned(), "marker = \"tipp\"\n" + here + "time_s = 0.5\n", "\"tipp\"", "0.marker", "\"tip\""},
        BadGoal{planned(), "marker = \"base\"\n" + here + "time_s = 0.5\n", "\"base\"\nplace", "0.marker",
                "on the body"},
        BadGoal{planned(), tip + here, "[[trial.goal]]", "0.time_s", "missing"},
        BadGoal{planned(), tip + "time_s = 0.5\n", "[[trial.goal]]", "0.place_m", "missing"},
        BadGoal{planned(), tip + here + "time_s = 1.5\n", "time_s = 1.5", "0.time_s", "after the end of the trial"},
        BadGoal{planned(), tip + here + "time_s = -0.5\n", "time_s = -0.5", "0.time_s", ""},
        BadGoal{planned(), tip + here + "time_s = 0.5\nuntil_s = 0.4\n", "until_s = 0.4", "0.until_s", "after time_s"},
        BadGoal{planned(), tip + here + "time_s = 0.5\nuntil_s = 1.4\n", "until_s = 1.4", "0.until_s", "after the end"},
        BadGoal{planned(), tip + here + "time_s = 0.5\nweight = 0.0\n", "weight", "0.weight", ""},
        BadGoal{planned(), tip + here + "time_s = 0.5\naxes = [\"q\"]\n", "axes", "0.axes", "at most once"},
        BadGoal{planned(), tip + here + "time_s = 0.5\naxes = []\n", "axes", "0.axes", "at least one"},
        BadGoal{planned(), tip + here + "path = \"goal.csv\"\n", "path = ", "0.path", "beside place_m"},
        BadGoal{planned(), tip + "path = \"goal.csv\"\ntime_s = 0.1\n", "time_s = 0.1", "0.time_s", "its own times"},
        BadGoal{planned(), "marker = \"side\"\npath = \"goal.csv\"\n", "path = ", "0.path", "not numbers"},
        BadGoal{planned(), tip + "path = \"none.csv\"\n", "path = ", "0.path", "none.csv"},
        BadGoal{planned(), tip + "times_s = [0.1]\nplaces_m = [[0, 0, 0], [1, 0, 0]]\n", "times_s = ", "0.times_s",
                "2"},
        BadGoal{planned(), tip + "times_s = [0.2, 0.1]\nplaces_m = [[0, 0, 0], [1, 0, 0]]\n", "times_s = ", "0.times_s",
                "ascend"},
        BadGoal{planned(), tip + "times_s = [0.2]\nplaces_m = [[0, 0, 0]]\n", "times_s = ", "0.times_s",
                "less than two"},
        BadGoal{planned(), tip + here + "time_s = 0.5\nuntil_s = 0.8\n[[trial.goal]]\n" + tip + here + "time_s = 0.6\n",
                "marker = \"tip\"\nplace_m = [0.1, 0.0, 0.0]\ntime_s = 0.6", "1.marker", "another goal"},
        BadGoal{held_toml(), tip + here + "time_s = 0.0\n", "time_s = 0.0\n", "0.time_s", "hold"},
        BadGoal{held_toml(), tip + "path = \"goal.csv\"\n", "[[trial.goal]]", "0.place_m", "one pose"}));

}  // namespace
}  // namespace myo::experiment
