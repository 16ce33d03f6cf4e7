#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibration/gradcheck.hpp"
#include "calibration/optimize.hpp"
#include "calibration/sought_signals.hpp"
#include "prediction/trial_goals.hpp"
#include "prediction/trial_target.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"
#include "support/muscle_beam.hpp"

// Signals that bring markers to goals, without any recording.

namespace myo::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// A planned trial of the beam with a muscle above, 0.3 s long.
///
/// @param signal  content of its actuation file
setup::Setup muscle_beam(const test::Folder& folder, const std::string& signal) {
    std::string toml = test::muscle_beam_toml();
    const std::string first = toml.substr(0, toml.find("[[trial]]"));
    toml = testing_support::replaced(first, "calibrate = [\"youngs_modulus\"]\n", "calibrate = []\n") +
           "[[trial]]\nname = \"reach\"\nrole = \"simulate\"\nduration_s = 0.3\nstart = \"equilibrium\"\nactuation = "
           "\"s.csv\"\n";
    Result<setup::Setup> setup = test::muscle_beam_setup(folder, toml, signal);
    EXPECT_TRUE(setup) << setup.error().text();
    return *std::move(setup);
}

experiment::GoalDeclaration goal_at(const std::string& marker, const Eigen::Vector3d& place_m, double time_s) {
    experiment::GoalDeclaration goal;
    goal.marker = marker;
    goal.times_s = Eigen::VectorXd::Constant(1, time_s);
    goal.places_m = place_m;
    return goal;
}

/// Where the markers are under the declared signals at this sample, as goals.
std::vector<experiment::GoalDeclaration> goals_of_run(const setup::Setup& setup, Index sample) {
    const prediction::TrialPrediction run = prediction::predict_trial(setup, 0, prediction::declared_values(setup));
    EXPECT_TRUE(run.ok()) << run.message;
    std::vector<experiment::GoalDeclaration> goals;
    for (std::size_t m = 0; m < setup.marker_names.size(); ++m)
        goals.push_back(
            goal_at(setup.marker_names[m], run.positions_m[m].col(sample), setup.trials[0].measured.time_s(sample)));
    return goals;
}

OptimizeSettings goal_settings() {
    OptimizeSettings settings;
    settings.frequency_Hz = 20.0;
    settings.smoothness_m_s = 1e-8;
    return settings;
}

/// The planned beam at rest, with the place to which a known signal brings it as its goals.
setup::Setup beam_with_goals(const test::Folder& folder) {
    const setup::Setup driven = muscle_beam(folder, "time_s,up\n0,1\n0.3,0.85\n");
    setup::Setup setup = muscle_beam(folder, "time_s,up\n0,1\n");
    setup.experiment.trials[0].goals = goals_of_run(driven, 28);
    Result<setup::Setup> target = prediction::with_goals(std::move(setup));
    EXPECT_TRUE(target) << target.error().text();
    return *std::move(target);
}

TEST(OptimizeGoals, ReachesWhatAKnownSignalReaches) {
    const test::Folder folder("goals_reached");
    setup::Setup setup = beam_with_goals(folder);
    const Result<inverse::ActuationProblem> problem = actuation_problem(setup, goal_settings());
    ASSERT_TRUE(problem) << problem.error().text();
    EXPECT_NEAR(problem->options.end_s, 0.28, 1e-9) << "signals after the last goal are not determined";
    Optimization found = search_signals(setup, *problem, goal_settings(), first_values(setup, problem->sought));
    ASSERT_TRUE(found.usable()) << found.fit.message;
    judge_signals(setup, found);
    EXPECT_GT(found.before.fit_rms_m, 1e-3);
    EXPECT_LT(found.after.fit_rms_m, 0.02 * found.before.fit_rms_m);
    EXPECT_TRUE(found.miss.reached);
    EXPECT_TRUE(found.miss.goals);
    EXPECT_THAT(found.deviations.reason, testing::HasSubstr("goals"));
    test::record("rms_m", std::vector<double>{found.before.fit_rms_m, found.after.fit_rms_m});
    // After the last goal the signal keeps its last value.
    const std::vector<fibre::Signal> signals = found_commands(problem->sought, found.fit.values);
    EXPECT_EQ(signals[0].value(10.0), signals[0].value(0.28));
    EXPECT_LT(signals[0].values.back(), 0.97) << "it does not return to rest";
    const std::vector<double>& values = signals[0].values;
    test::record("last_values", std::vector<double>(values.end() - 3, values.end()));
}

/// The last goal lies between two knots: what the last knot says after it is of no one's making.
TEST(OptimizeGoals, LeaveSignalsAtTheValueOfTheLastGoal) {
    const test::Folder folder("goals_end");
    const setup::Setup setup = beam_with_goals(folder);
    OptimizeSettings how = goal_settings();
    const auto sought_until = [&](double end_s) { return sought_signals(setup, how, end_s); };
    const inverse::SoughtSignals sought = sought_until(0.28);
    MatrixXd values = inverse::unmoved_values(sought);
    for (Index k = 0; k < values.cols(); ++k) values(0, k) = 1.0 - 0.02 * static_cast<double>(k * k);
    const fibre::Signal free = inverse::commands_of(sought, values)[0], held = found_commands(sought, values)[0];
    for (const double t : {0.0, 0.13, 0.26, 0.28}) EXPECT_NEAR(held.value(t), free.value(t), 1e-15) << t;
    EXPECT_NE(free.value(0.3), free.value(0.28));
    for (const double t : {0.29, 0.3, 5.0}) EXPECT_EQ(held.value(t), held.value(0.28)) << t;
    const inverse::SoughtSignals whole = sought_until(0.3);
    EXPECT_EQ(found_commands(whole, values)[0], inverse::commands_of(whole, values)[0]) << "the end is a knot";
    how.hold = true;
    const inverse::SoughtSignals steps = sought_until(0.28);
    const MatrixXd levels = inverse::unmoved_values(steps);
    EXPECT_EQ(found_commands(steps, levels)[0], inverse::commands_of(steps, levels)[0]);
}

TEST(OptimizeGoals, HaveTheGradientOfTheirWeightedDistance) {
    const test::Folder folder("goals_gradient");
    setup::Setup planned = muscle_beam(folder, "time_s,up\n0,1\n");
    experiment::GoalDeclaration path = goal_at("tip_left", {0.09, 0.0, 0.04}, 0.0);
    path.times_s = Eigen::Vector3d(0.1, 0.145, 0.25);
    path.places_m.resize(3, 3);
    path.places_m << 0.1, 0.098, 0.095, 0.0, 0.001, 0.0, 0.03, 0.035, 0.04;
    path.axes = {true, false, true};
    path.weight = 0.3;
    planned.experiment.trials[0].goals = {path, goal_at("middle", {0.05, 0.015, 0.031}, 0.213)};
    const Result<setup::Setup> setup = prediction::with_goals(std::move(planned));
    ASSERT_TRUE(setup) << setup.error().text();
    Result<inverse::ActuationProblem> problem = actuation_problem(*setup, goal_settings());
    ASSERT_TRUE(problem) << problem.error().text();
    problem->options.solver.tolerance = problem->options.solver.tangent_tolerance = 1e-11;
    problem->smoothness_m_s = 1e-4;
    MatrixXd values = inverse::unmoved_values(problem->sought);
    for (Index k = 0; k < values.cols(); ++k) values(0, k) = 1.0 - 0.03 * std::sin(1.0 + static_cast<double>(k));
    const inverse::ActuationEvaluation here = inverse::evaluate_actuation(*problem, values);
    ASSERT_TRUE(here.ok()) << here.message;
    std::vector<double> errors;
    for (Index i = 0; i < values.size(); ++i) {
        constexpr double h = 1e-4;
        const auto loss = [&](double by) {
            MatrixXd changed = values;
            changed(i) += by;
            return inverse::evaluate_actuation(*problem, changed).loss_m2;
        };
        const double difference = (loss(h) - loss(-h)) / (2.0 * h);
        EXPECT_NE(difference, 0.0);
        EXPECT_NE(difference, here.gradient(i));
        errors.push_back(std::abs(here.gradient(i) / difference - 1.0));
        EXPECT_LT(errors.back(), 1e-4) << "value " << i;
    }
    test::record("relative_errors", errors);
}

/// The weighted loss is the mean of the squared distances, each goal once however often it is sampled.
TEST(OptimizeGoals, CountEachGoalByItsWeight) {
    const test::Folder folder("goals_weights");
    setup::Setup planned = muscle_beam(folder, "time_s,up\n0,1\n");
    const std::vector<experiment::GoalDeclaration> at = goals_of_run(planned, 20);
    experiment::GoalDeclaration near = at[0], far = at[3];
    near.places_m.array() += 1e-3;
    far.places_m.array() += 2e-3;
    far.weight = 3.0;
    planned.experiment.trials[0].goals = {near, far};
    const Result<setup::Setup> setup = prediction::with_goals(std::move(planned));
    ASSERT_TRUE(setup);
    const Result<inverse::ActuationProblem> problem = actuation_problem(*setup, goal_settings());
    ASSERT_TRUE(problem);
    const inverse::ActuationEvaluation here = inverse::evaluate_actuation(*problem,
                                                                          inverse::unmoved_values(problem->sought));
    ASSERT_TRUE(here.ok()) << here.message;
    EXPECT_NEAR(here.rms_m, 1e-3 * std::sqrt((1.0 + 3.0 * 4.0) / 4.0), 2e-5);
}

TEST(OptimizeGoals, PassTheGradientCheck) {
    const test::Folder folder("goals_gradcheck");
    setup::Setup planned = muscle_beam(folder, "time_s,up\n0,1\n");
    experiment::GoalDeclaration path = goal_at("tip_left", {0.1, 0.0, 0.03}, 0.0);
    path.times_s = Eigen::Vector2d(0.0, 0.3);
    path.places_m.resize(3, 2);
    path.places_m << 0.1, 0.095, 0.0, 0.0, 0.03, 0.04;
    path.axes = {true, false, true};
    planned.experiment.trials[0].goals = {path, goal_at("middle", {0.05, 0.015, 0.031}, 0.013)};
    const Result<setup::Setup> setup = prediction::with_goals(std::move(planned));
    ASSERT_TRUE(setup) << setup.error().text();
    const TrialGradientCheck run = gradcheck(*setup, 0, 6);
    ASSERT_TRUE(run.check.complete()) << run.check.message;
    EXPECT_TRUE(run.against_trace) << "the goals";
    EXPECT_LT(run.check.worst_error(), 1e-5);
}

TEST(OptimizeGoals, AreReachedByTheTensionOfAHold) {
    const test::Folder folder("goals_hold");
    const auto beam = [&](double pull_N) {
        setup::Setup whole = test::chambered_beam(folder, 0.1, [&](experiment::Experiment& e) {
            e.chambers.clear();
            e.tendons.push_back(test::upper_tendon());
            e.trials.resize(1);
            experiment::TrialDeclaration& trial = e.trials[0];
            trial.role = experiment::TrialRole::simulate;
            trial.trace.clear();
            trial.hold = true;
            trial.start = experiment::StartState::equilibrium;
            if (pull_N > 0.0) trial.constant_commands = {{"upper", pull_N}};
        });
        return prediction::with_one_trial(std::move(whole), 0);
    };
    setup::Setup planned = beam(0.0);
    planned.experiment.trials[0].goals = goals_of_run(beam(1.2), 0);
    Result<setup::Setup> setup = prediction::with_goals(std::move(planned));
    ASSERT_TRUE(setup) << setup.error().text();
    const Result<inverse::ActuationProblem> problem = actuation_problem(*setup, goal_settings());
    ASSERT_TRUE(problem) << problem.error().text();
    ASSERT_TRUE(problem->sought.constant);
    const Optimization found = optimize_with_chosen_steps(*setup, *problem, goal_settings(),
                                                          first_values(*setup, problem->sought));
    ASSERT_TRUE(found.usable()) << found.fit.message;
    EXPECT_NEAR(found.fit.values(0), 1.2, 0.02);
    EXPECT_LT(found.after.fit_rms_m, 0.02 * found.before.fit_rms_m);
}

/// Steps of a whole sampling interval are halved, so that the search runs again; what it tells is counted once.
TEST(OptimizeGoals, CountTheSearchesWithLongerStepsOnce) {
    const test::Folder folder("goals_steps");
    setup::Setup setup = beam_with_goals(folder);
    setup.noise_m.setConstant(0.1);  // at this noise the goals are reached from the start: one evaluation per search
    const double interval_s = setup::sampling_interval_s(setup.trials[0]);
    setup::set_step(setup.trials[0], interval_s);
    OptimizeSettings settings = goal_settings();
    int told = 0;
    settings.evaluated = [&](const inverse::ActuationFit&) { ++told; };
    const Result<inverse::ActuationProblem> problem = actuation_problem(setup, settings);
    ASSERT_TRUE(problem) << problem.error().text();
    const Optimization found = optimize_with_chosen_steps(setup, *problem, settings,
                                                          first_values(setup, problem->sought));
    ASSERT_TRUE(found.usable()) << found.fit.message;
    EXPECT_LT(setup.trials[0].options.h_s, 0.51 * interval_s);
    EXPECT_GE(found.starts.size(), 2u);
    EXPECT_EQ(found.evaluations() + found.earlier_evaluations, told);
}

TEST(OptimizeGoals, NeedAGoalAfterTheStart) {
    const test::Folder folder("goals_start");
    setup::Setup planned = muscle_beam(folder, "time_s,up\n0,1\n");
    const Result<inverse::ActuationProblem> none = actuation_problem(planned, goal_settings());
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().what, testing::HasSubstr("neither a recording nor a [[trial.goal]]"));
    planned.experiment.trials[0].goals = {goal_at("middle", {0.05, 0.015, 0.031}, 0.0)};
    const Result<setup::Setup> setup = prediction::with_goals(std::move(planned));
    ASSERT_TRUE(setup);
    const Result<inverse::ActuationProblem> problem = actuation_problem(*setup, goal_settings());
    ASSERT_FALSE(problem);
    EXPECT_THAT(problem.error().what, testing::HasSubstr("lies after its start"));
}

}  // namespace
}  // namespace myo::calibration
