#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/curve_text.hpp"
#include "commands/muscle_signal.hpp"
#include "commands/search_target.hpp"
#include "commands/signal_shapes.hpp"
#include "commands/workbench_state.hpp"

// Trials, loads, targets and signals, from values alone.

namespace myo::ui::scene_rules {
namespace {

using commands::Muscle;
using commands::SceneTrial;
using fibre::Signal;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(SceneTrials, AMarkerIsSeenIfAnyOfItsValuesIs) {
    SceneTrial trial;
    trial.measured = {Eigen::Matrix3Xd::Constant(3, 4, nan), Eigen::Matrix3Xd::Constant(3, 4, nan),
                      Eigen::Matrix3Xd::Zero(3, 4)};
    trial.measured[1](2, 3) = 0.0;
    for (const auto& [marker, seen] :
         std::vector<std::pair<std::size_t, bool>>{{0, false}, {1, true}, {2, true}, {3, false}})
        EXPECT_EQ(commands::is_seen(trial, marker), seen) << marker;
}

TEST(SceneTrials, TheIntervalIsTheMeanOfAllSamples) {
    SceneTrial trial;
    EXPECT_EQ(commands::sample_interval_s(trial), 0.0);
    trial.time_s = Eigen::VectorXd::Constant(1, 3.0);
    EXPECT_EQ(commands::sample_interval_s(trial), 0.0) << "one sample has none";
    trial.time_s = Eigen::Vector4d(-1.0, 0.0, 0.5, 2.0);
    EXPECT_EQ(commands::sample_interval_s(trial), 1.0);
}

TEST(SceneLoads, AForceActsFromItsFirstToItsLastMoment) {
    commands::SceneLoad load;
    for (const double t : {-1e9, 0.0, 1e9}) EXPECT_EQ(load.factor(t), 1.0) << "without times always";
    load.from_s = 0.5;
    load.until_s = 1.5;
    for (const auto& [t, factor] : std::vector<std::pair<double, double>>{
             {0.4999, 0.0}, {0.5, 1.0}, {1.0, 1.0}, {1.5, 1.0}, {1.5001, 0.0}, {nan, 0.0}})
        EXPECT_EQ(load.factor(t), factor) << t;
    // A curve takes the place of the times.
    load.curve = Signal{{0.0, 2.0}, {0.0, 3.0}};
    EXPECT_DOUBLE_EQ(load.factor(0.2), 0.3);
    EXPECT_EQ(load.factor(7.0), 3.0);
}

TEST(Targets, AreGoalsOrARecordingThatIsNotOnlyPlanned) {
    SceneTrial trial;
    trial.name = "reach";
    for (const char* role : {"fit", "validate", "simulate"}) {
        trial.role = role;
        const bool measured_role = trial.role != "simulate";
        trial.measured.clear();
        trial.goals.clear();
        EXPECT_FALSE(commands::has_target(trial)) << role;
        trial.measured.resize(2);
        EXPECT_EQ(commands::has_target(trial), measured_role) << role;
        trial.goals.resize(1);
        EXPECT_TRUE(commands::has_target(trial)) << role;
        commands::Scene scene;
        EXPECT_FALSE(commands::any_goals(scene));
        EXPECT_FALSE(commands::can_be_diagnosed(scene));
        scene.trials = {SceneTrial{}, trial};
        EXPECT_TRUE(commands::any_goals(scene));
        EXPECT_EQ(commands::can_be_diagnosed(scene), trial.role == "fit") << role;
    }
    EXPECT_EQ(commands::target_words(trial), "1 goal of reach");
    trial.goals.resize(3);
    EXPECT_EQ(commands::target_words(trial), "3 goals of reach");
}

TEST(Targets, ARequestKeepsWhatIsStillOffered) {
    commands::Scene scene;
    scene.seekable = {{"modulus", "Young's modulus"}};
    commands::Settings settings;
    commands::OptimizeRequest request;
    request.seek = {"gone", "modulus", "weights:left"};
    const auto offered = [&] { return commands::offered_request(scene, settings, request); };
    EXPECT_EQ(offered().seek, (std::vector<std::string>{"modulus"}));
    EXPECT_FALSE(offered().signals) << "nothing has a signal";
    for (int with = 0; with < 3; ++with) {
        scene.declared.chambers.clear();
        scene.declared.tendons.clear();
        settings.muscles.clear();
        if (with == 0) settings.muscles.resize(1);
        if (with == 1) scene.declared.chambers.emplace_back();
        if (with == 2) scene.declared.tendons.emplace_back();
        EXPECT_TRUE(offered().signals) << with;
    }
    request.signals = false;
    EXPECT_FALSE(offered().signals) << "it was not asked for";
    settings.muscles.resize(1);
    settings.muscles[0].name = "left";
    settings.muscles[0].paint = std::make_shared<const fibre::PaintedMask>();
    EXPECT_EQ(offered().seek, (std::vector<std::string>{"modulus", "weights:left"}));
    EXPECT_EQ(offered().max_evaluations, request.max_evaluations);
}

/// A state whose first trial recorded the signal of "left".
commands::WorkbenchState with_recorded(const Signal& signal) {
    auto scene = std::make_shared<commands::Scene>();
    scene->trials.resize(2);
    scene->trials[0].activation["left"] = signal;
    commands::WorkbenchState state;
    state.scene = scene;
    return state;
}

TEST(SignalOfAMuscle, IsItsOwnThenTheRecordedOneThenPassive) {
    const Signal recorded{{0.0, 1.0}, {1.0, 0.7}}, own{{0.0}, {0.8}}, passive = Signal::constant(1.0);
    commands::WorkbenchState state = with_recorded(recorded);
    Muscle muscle;
    muscle.name = "upper";
    EXPECT_EQ(commands::signal_of(state, muscle), passive) << "it is not declared";
    muscle.declared = "left";
    EXPECT_EQ(commands::signal_of(state, muscle), recorded) << "whatever its name is now";
    state.trial = 1;
    EXPECT_EQ(commands::signal_of(state, muscle), passive) << "this trial did not record it";
    state.trial = 5;
    EXPECT_EQ(commands::signal_of(state, muscle), passive) << "there is no such trial";
    muscle.signal = own;
    EXPECT_EQ(commands::signal_of(state, muscle), own);
    EXPECT_EQ(commands::signal_of({}, muscle), own);
}

TEST(SignalOfAMuscle, FollowsItsLeaderByTheRatioOfWhatExceedsPassive) {
    commands::WorkbenchState state = with_recorded({{0.0, 1.0}, {1.0, 0.6}});
    Muscle leader, follower;
    leader.name = "upper";
    leader.declared = "left";
    follower.name = "lower";
    follower.follows = "upper";
    follower.ratio = -0.5;
    follower.signal = Signal::constant(9.0);  // kept for the time when it follows no more
    state.settings.muscles = {follower, leader};
    const Signal followed = commands::signal_of(state, follower);
    EXPECT_EQ(followed.times_s, (std::vector<double>{0.0, 1.0}));
    EXPECT_EQ(followed.values[0], 1.0) << "passive with a passive leader";
    EXPECT_DOUBLE_EQ(followed.values[1], 1.2) << "an antagonist";
    // Without a leader of its own signal a muscle is passive, also if two follow each other.
    state.settings.muscles = {follower};
    EXPECT_EQ(commands::signal_of(state, follower), Signal::constant(1.0));
    leader.follows = "lower";
    state.settings.muscles = {follower, leader};
    EXPECT_EQ(commands::signal_of(state, follower), Signal::constant(1.0));
}

TEST(Knots, KeepATenthOfAMillisecondBetweenThem) {
    const Signal signal{{0.0, 1.0, 2.0}, {1.0, 0.8, 0.9}};
    EXPECT_EQ(commands::with_knot_added(signal, 0.9999 + 2e-5, 0.5), signal) << "too near before a knot";
    EXPECT_EQ(commands::with_knot_added(signal, 1.0 + 8e-5, 0.5), signal) << "too near behind one";
    EXPECT_EQ(commands::with_knot_added(signal, 1.0 + 1.2e-4, 0.5).times_s.size(), 4u);
    EXPECT_EQ(commands::with_knot_added(signal, 1.0 - 1.2e-4, 0.5).times_s.size(), 4u);
    EXPECT_EQ(commands::with_knot_added(signal, -5.0, 0.5).times_s.front(), -5.0);
    EXPECT_EQ(commands::with_knot_added(signal, 5.0, 0.5).values.back(), 0.5);
    // The first and the last one move freely to their open side.
    EXPECT_EQ(commands::with_knot_moved(signal, 0, -7.0, 0.5).times_s[0], -7.0);
    EXPECT_EQ(commands::with_knot_moved(signal, 2, 70.0, 0.5).times_s[2], 70.0);
    EXPECT_NEAR(commands::with_knot_moved(signal, 0, 7.0, 0.5).times_s[0], 1.0 - 1e-4, 1e-12);
    // Between neighbours without room for it only the value changes.
    const Signal crowded{{0.0, 1e-4, 1.5e-4}, {1.0, 0.8, 0.9}};
    const Signal moved = commands::with_knot_moved(crowded, 1, 0.5, 0.25);
    EXPECT_EQ(moved.times_s, crowded.times_s);
    EXPECT_EQ(moved.values[1], 0.25);
}

TEST(CurveText, HasARowPerKnotThatReadsAsTheSameNumber) {
    EXPECT_EQ(commands::curve_text(Signal::constant(1.0)), "[[0.0, 1.0]]");
    EXPECT_EQ(commands::curve_text({{0.0, 0.25}, {1.0, -2.5}}), "[[0.0, 1.0], [0.25, -2.5]]");
    const double third = 1.0 / 3.0;
    const std::string text = commands::curve_text({{third}, {-third}});
    EXPECT_EQ(std::stod(text.substr(2)), third);
    EXPECT_EQ(std::stod(text.substr(text.find(", ") + 2)), -third);
}

}  // namespace
}  // namespace myo::ui::scene_rules
