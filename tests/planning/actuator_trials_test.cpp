#include "planning/actuator_trials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "planning/planned_trials.hpp"
#include "planning/round_numbers.hpp"

// Trials that drive one actuator at a time, from experiments that were never meshed, and the numbers in them.

namespace myo::planning::actuator_trials_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const TrialDurations durations{1.0, 2.0};

/// Muscles "lead", "after" (follows) and "own" (has a signal), a chamber and two tendons.
setup::Setup robot() {
    setup::Setup setup;
    experiment::Experiment& e = setup.experiment;
    e.muscles.resize(3);
    e.muscles[0].name = "lead";
    e.muscles[1].name = "after";
    e.muscles[1].follows = experiment::FollowsDeclaration{"lead", -1.0};
    e.muscles[2].name = "own";
    e.muscles[2].signal = fibre::Signal::constant(0.9);
    e.chambers = {{"upper room", Eigen::Vector3d::Zero()}};
    e.tendons.resize(2);
    e.tendons[0].name = "pulled";
    e.tendons[1].name = "wound";
    e.tendons[1].drive = experiment::TendonDrive::shortening;
    return setup;
}

/// A trial in which the actuators have these values, in their order.
void add_trial(const std::vector<double>& values, setup::Setup& setup) {
    setup::PreparedTrial trial;
    for (std::size_t i = 0; i < values.size(); ++i)
        (i < setup.experiment.muscles.size() ? trial.recorded_activation : trial.recorded_commands)
            .push_back(fibre::Signal::step(0.1, i < 3 ? 1.0 : 0.0, values[i]));
    setup.trials.push_back(std::move(trial));
}

std::vector<std::string> names_of(const std::vector<PossibleTrial>& trials) {
    std::vector<std::string> names;
    for (const PossibleTrial& trial : trials) names.push_back(trial.name);
    return names;
}

const PossibleTrial& named(const std::vector<PossibleTrial>& trials, const std::string& name) {
    const auto found = std::find_if(trials.begin(), trials.end(),
                                    [&](const PossibleTrial& trial) { return trial.name == name; });
    EXPECT_NE(found, trials.end()) << name;
    return found == trials.end() ? trials.front() : *found;
}

TEST(ActuatorTrials, NeedAnActuatorThatActedOrHasALimit) {
    setup::Setup setup = robot();
    add_trial({1.0, 0.5, 0.9, 0.0, 0.0, 0.0}, setup);
    EXPECT_THAT(names_of(actuator_trials(setup, {}, durations, {})), IsEmpty())
        << "a follower and a muscle with a signal of its own are not set by a trial";
    experiment::LimitsDeclaration limits;
    limits.shortening_m = 0.02;
    EXPECT_THAT(names_of(actuator_trials(setup, limits, durations, {})),
                ElementsAre("next_step_wound", "next_small_step_wound", "next_long_step_wound", "next_ramp_wound",
                            "next_sine_wound"));
    // Poses only where the experiment measures some.
    setup.trials[0].hold = true;
    const std::vector<PossibleTrial> trials = actuator_trials(setup, limits, durations, {});
    EXPECT_EQ(trials.size(), 6u);
    EXPECT_EQ(named(trials, "next_hold_wound").keys, "hold = true\nshortening_m = { wound = 0.02 }\n");
}

/// The value farthest from rest counts, whatever its sign, and a limit holds for both signs.
TEST(ActuatorTrials, GoAsFarAsTrialsWentWithinTheLimit) {
    setup::Setup setup = robot();
    add_trial({0.9, 1.0, 0.9, 2000.0, 1.0, 0.0}, setup);
    add_trial({1.05, 1.0, 0.9, -3456.0, 4.0, 0.0}, setup);
    const auto level_of = [&](const std::string& name, const experiment::LimitsDeclaration& limits) {
        const std::string keys = named(actuator_trials(setup, limits, durations, {}), "next_step_" + name).keys;
        return std::stod(keys.substr(keys.rfind('=') + 1));
    };
    experiment::LimitsDeclaration limits;
    EXPECT_DOUBLE_EQ(level_of("lead", limits), 0.9);
    EXPECT_DOUBLE_EQ(level_of("upper room", limits), -3500.0) << "in two digits";
    EXPECT_DOUBLE_EQ(level_of("pulled", limits), 4.0);
    limits.activation = 0.96;
    limits.pressure_Pa = 1000.0;
    limits.tension_N = 9.0;
    EXPECT_DOUBLE_EQ(level_of("lead", limits), 0.96);
    EXPECT_DOUBLE_EQ(level_of("upper room", limits), -1000.0);
    EXPECT_DOUBLE_EQ(level_of("pulled", limits), 4.0) << "a limit above what was seen asks for no more";
}

TEST(ActuatorTrials, StateWhatIsDoneInWordsAndKeys) {
    setup::Setup setup = robot();
    add_trial({1.0, 1.0, 0.9, 2000.0, 0.0, 0.0}, setup);
    const std::vector<PossibleTrial> trials = actuator_trials(setup, {}, durations, {});
    const PossibleTrial &step = named(trials, "next_step_upper room"),
                        &small = named(trials, "next_small_step_upper room"),
                        &slow = named(trials, "next_long_step_upper room"),
                        &ramp = named(trials, "next_ramp_upper room");
    EXPECT_EQ(step.words, "upper room steps to 2000 Pa at t = 0 and stays there for 1 s");
    EXPECT_EQ(step.keys, "duration_s = 1.0\nstart = \"equilibrium\"\nactuation_step = { \"upper room\" = 2000.0 }\n");
    EXPECT_THAT(small.keys, HasSubstr("{ \"upper room\" = 1000.0 }"));
    EXPECT_THAT(slow.keys, HasSubstr("duration_s = 2.0\n"));
    EXPECT_THAT(slow.words, HasSubstr("for 2 s"));
    EXPECT_EQ(ramp.words, "upper room rises slowly to 2000 Pa within 1.6 s and falls back");
    EXPECT_EQ(ramp.keys,
              "duration_s = 2.0\nstart = \"equilibrium\"\npressure_Pa = { \"upper room\" = [[0.0, 0.0], [1.6, "
              "2000.0], [2.0, 0.0]] }\n");
    for (const PossibleTrial& trial : trials) EXPECT_FALSE(trial.signal) << "only curves of muscles need a file";
}

/// A sine between rest and extreme: (1 - cos)/2 from rest, with the stated frequency, for the whole trial.
TEST(ActuatorTrials, SwingMusclesBetweenRestAndTheirExtreme) {
    setup::Setup setup = robot();
    add_trial({0.8, 1.0, 0.9, 0.0, 0.0, 0.0}, setup);
    FamilyPolicy policy;
    policy.sine_periods = 5.0;
    const std::vector<PossibleTrial> trials = actuator_trials(setup, {}, durations, policy);
    const PossibleTrial& sine = named(trials, "next_sine_lead");
    EXPECT_EQ(sine.words, "lead swings between rest and 0.8 with 5 Hz");
    EXPECT_EQ(sine.keys, "duration_s = 1.0\nstart = \"equilibrium\"\n") << "the curve is in the file";
    ASSERT_TRUE(sine.signal);
    EXPECT_THAT(sine.signal->muscles, ElementsAre("lead"));
    const Eigen::VectorXd& at = sine.signal->time_s;
    EXPECT_EQ(at(0), 0.0);
    EXPECT_DOUBLE_EQ(at(1), policy.lead_s);
    EXPECT_NEAR(at(at.size() - 1), policy.lead_s + durations.usual_s - policy.sample_s, 1e-9);
    for (Eigen::Index k = 1; k < at.size(); ++k) {
        EXPECT_GT(at(k), at(k - 1));
        const double share = 0.5 - 0.5 * std::cos(2.0 * M_PI * 5.0 * (at(k) - policy.lead_s));
        EXPECT_NEAR(sine.signal->values(0, k), 1.0 - 0.2 * share, 0.0052) << "half a second digit";
    }
    EXPECT_EQ(sine.signal->values(0, 0), 1.0);
    EXPECT_NEAR(sine.signal->values.minCoeff(), 0.8, 1e-12);
    const PossibleTrial& ramp = named(trials, "next_ramp_lead");
    ASSERT_TRUE(ramp.signal);
    EXPECT_TRUE(ramp.signal->values.isApprox(Eigen::RowVector3d(1.0, 0.8, 1.0)));
    EXPECT_TRUE(ramp.signal->time_s.isApprox(Eigen::Vector3d(0.0, 1.6, 2.0)));
}

/// A second muscle that can be set stands in the file as well, passive.
TEST(ActuatorTrials, KeepOtherMusclesPassiveInTheFile) {
    setup::Setup setup = robot();
    setup.experiment.muscles[1].follows.reset();
    add_trial({0.8, 0.7, 0.9, 0.0, 0.0, 0.0}, setup);
    const std::vector<PossibleTrial> trials = actuator_trials(setup, {}, durations, {});
    const PossibleTrial& ramp = named(trials, "next_ramp_after");
    ASSERT_TRUE(ramp.signal);
    EXPECT_THAT(ramp.signal->muscles, ElementsAre("lead", "after"));
    EXPECT_TRUE((ramp.signal->values.row(0).array() == 1.0).all());
    EXPECT_NEAR(ramp.signal->values(1, 1), 0.7, 1e-12);
}

TEST(RoundNumbers, HaveTwoDigits) {
    for (const auto& [value, nearest, below] : std::vector<std::array<double, 3>>{{0.0, 0.0, 0.0},
                                                                                  {1.2, 1.2, 1.2},
                                                                                  {0.3, 0.3, 0.3},
                                                                                  {0.1 + 0.2, 0.3, 0.3},
                                                                                  {1.29, 1.3, 1.2},
                                                                                  {126.0, 130.0, 120.0},
                                                                                  {9.99, 10.0, 9.9},
                                                                                  {0.0999, 0.1, 0.099},
                                                                                  {1.26e-9, 1.3e-9, 1.2e-9},
                                                                                  {123456.0, 120000.0, 120000.0}}) {
        EXPECT_DOUBLE_EQ(rounded(value), nearest) << value;
        EXPECT_DOUBLE_EQ(rounded_down(value), below) << value;
        EXPECT_EQ(rounded(rounded(value)), rounded(value)) << value;
        EXPECT_EQ(rounded_down(rounded_down(value)), rounded_down(value)) << value;
    }
    EXPECT_DOUBLE_EQ(rounded(-0.0456), -0.046);
    EXPECT_EQ(rounded(std::nan("")), 0.0);
}

/// Every marker of a trial without a recording counts as seen, but for probes; recordings stay as they are.
TEST(PlannedTrials, ShowTheMarkersOfTrialsThatAreOnlySimulated) {
    setup::Setup setup;
    setup.experiment.markers.on_body = {{"tip", Eigen::Vector3d::Zero(), "tip", false},
                                        {"probe", Eigen::Vector3d::Zero(), "probe", true}};
    setup.trials.resize(3);
    const experiment::TrialRole roles[] = {experiment::TrialRole::simulate, experiment::TrialRole::fit,
                                           experiment::TrialRole::validate};
    for (std::size_t t = 0; t < 3; ++t) {
        setup.trials[t].role = roles[t];
        setup.trials[t].measured.tracks.assign(2, Eigen::Matrix3Xd::Constant(3, 4, std::nan("")));
    }
    setup::Setup none = setup;
    none.trials.erase(none.trials.begin() + 1);
    EXPECT_TRUE(has_fit_recording(setup));
    EXPECT_FALSE(has_fit_recording(none)) << "a trial to predict is no recording to fit";
    const setup::Setup planned = with_planned_trials(setup);
    EXPECT_EQ(planned.trials[0].role, experiment::TrialRole::fit);
    EXPECT_TRUE(planned.trials[0].measured.tracks[0].isZero(0.0));
    EXPECT_FALSE(planned.trials[0].measured.tracks[1].allFinite());
    EXPECT_FALSE(planned.trials[1].measured.tracks[0].allFinite());
    EXPECT_EQ(planned.trials[2].role, experiment::TrialRole::validate);
    EXPECT_FALSE(planned.trials[2].measured.tracks[0].allFinite());
}

}  // namespace
}  // namespace myo::planning::actuator_trials_test
