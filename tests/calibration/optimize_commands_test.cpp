#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calibration/optimize.hpp"
#include "calibration/sought_signals.hpp"
#include "prediction/trial_target.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"

namespace myo::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Commands every 0.05 s, linear in between.
const std::vector<double> pressure_Pa{0.0, 6000.0, 9000.0};
const std::vector<double> tension_N{0.0, 1.5, 0.5};

/// Actuation file of the chamber and of the tendon "cable".
std::string commands_csv() {
    std::string text = "time_s,upper_Pa,cable_N\n";
    for (std::size_t k = 0; k < pressure_Pa.size(); ++k)
        text += std::to_string(0.05 * static_cast<double>(k)) + "," + std::to_string(pressure_Pa[k]) + "," +
                std::to_string(tension_N[k]) + "\n";
    return text;
}

/// Gives the trial the motion under its commands as recording.
setup::Setup recorded(setup::Setup whole) {
    setup::Setup setup = prediction::with_one_trial(std::move(whole), 0);
    const prediction::TrialPrediction motion = prediction::predict_trial(setup, 0, prediction::declared_values(setup));
    EXPECT_TRUE(motion.ok()) << motion.message;
    setup.trials[0].measured.tracks = motion.positions_m;
    return setup;
}

/// The chambered beam with a tendon below, moved by both.
setup::Setup driven_beam(const test::Folder& folder, const std::vector<effect::EffectDeclaration>& effects) {
    folder.write("commands.csv", commands_csv());
    return recorded(test::chambered_beam(folder, 0.1, [&](experiment::Experiment& e) {
        e.tendons.push_back(test::upper_tendon(Eigen::RowVector4d::Constant(0.002)));
        e.tendons.back().name = "cable";
        e.trials[0].actuation = folder.path() / "commands.csv";
        e.effects = effects;
    }));
}

OptimizeSettings slow_signals() {
    OptimizeSettings settings;
    settings.frequency_Hz = 20.0;
    settings.smoothness_m_s = 1e-8;
    return settings;
}

/// The gradient by pressures and tensions, through a lag and the friction of the tendon.
TEST(OptimizeCommands, HasTheGradientOfPressureAndTension) {
    const test::Folder folder("commands_gradient");
    const setup::Setup setup = driven_beam(
        folder, {{"actuation_lag", {{"time_constant_s", 0.03}}}, {"tendon_friction", {{"coefficient", 0.2}}}});
    Result<inverse::ActuationProblem> problem = actuation_problem(setup, slow_signals());
    ASSERT_TRUE(problem) << problem.error().text();
    problem->options.solver.tolerance = problem->options.solver.tangent_tolerance = 1e-11;
    problem->smoothness_m_s = 1e-4;
    MatrixXd values(2, 3);
    values << 1000.0, 5000.0, 7000.0, 0.3, 1.0, 0.8;
    const inverse::ActuationEvaluation here = inverse::evaluate_actuation(*problem, values);
    ASSERT_TRUE(here.ok()) << here.message;
    std::vector<double> errors;
    for (Index i = 0; i < values.size(); ++i) {
        // The friction turns around within a small part of the tension.
        const double h = 1e-4 * problem->sought.signals[static_cast<std::size_t>(i % 2)].scale;
        const auto loss = [&](double by) {
            MatrixXd changed = values;
            changed(i) += by;
            return inverse::evaluate_actuation(*problem, changed).loss_m2;
        };
        const double difference = (loss(h) - loss(-h)) / (2.0 * h);
        EXPECT_NE(difference, 0.0);
        errors.push_back(std::abs(here.gradient(i) / difference - 1.0));
        EXPECT_LT(errors.back(), 1e-5) << "value " << i;
    }
    test::record("relative_errors", errors);
    std::sort(errors.begin(), errors.end());
    EXPECT_LE(errors[errors.size() / 2], 1e-6);
}

/// Markers tell pressure and tension apart; both courses are found from their own motion.
TEST(OptimizeCommands, FindsThePressureAndTheTensionThatMadeTheMotion) {
    const test::Folder folder("commands_found");
    const setup::Setup setup = driven_beam(folder, {});
    const Result<inverse::ActuationProblem> problem = actuation_problem(setup, slow_signals());
    ASSERT_TRUE(problem) << problem.error().text();
    ASSERT_EQ(problem->sought.signals.size(), 2u);
    EXPECT_EQ(problem->sought.signals[0].lower, 0.0);
    EXPECT_NEAR(problem->sought.signals[0].upper, 1.5 * 9000.0, 1e-9);
    EXPECT_NEAR(problem->sought.signals[1].upper, 1.5 * 1.5, 1e-12);
    Optimization found = search_signals(setup, *problem, slow_signals(), inverse::unmoved_values(problem->sought));
    ASSERT_TRUE(found.usable());
    // The last knot hardly moves anything any more.
    for (Index k = 0; k < 2; ++k) {
        EXPECT_NEAR(found.fit.values(0, k), pressure_Pa[static_cast<std::size_t>(k)], 150.0) << "knot " << k;
        EXPECT_NEAR(found.fit.values(1, k), tension_N[static_cast<std::size_t>(k)], 0.05) << "knot " << k;
    }
    EXPECT_LT(found.fit.best.rms_m, 0.02 * found.fit.first.rms_m);
    EXPECT_GE(found.fit.values.minCoeff(), 0.0);
    judge_signals(setup, found);
    ASSERT_TRUE(found.deviations.found) << found.deviations.reason;
    // In their own units.
    EXPECT_GT(found.deviations.deviations(0, 1), 10.0);
    EXPECT_LT(found.deviations.deviations(0, 1), 2000.0);
    EXPECT_LT(found.deviations.deviations(1, 1), 0.1);
    test::record("rms_m", std::vector<double>{found.fit.first.rms_m, found.fit.best.rms_m});
    test::record("values",
                 std::vector<double>(found.fit.values.data(), found.fit.values.data() + found.fit.values.size()));
}

/// The thread below the sagging beam is slack until it has taken in what the sag shortens it by.
TEST(OptimizeCommands, FindsTheShorteningOfASlackThread) {
    const test::Folder folder("commands_slack");
    const setup::Setup setup = recorded(test::chambered_beam(folder, 0.1, [](experiment::Experiment& e) {
        e.chambers.clear();
        e.tendons.push_back(test::upper_tendon(Eigen::RowVector4d::Constant(0.002)));
        e.tendons.back().drive = experiment::TendonDrive::shortening;
        experiment::TrialDeclaration& trial = e.trials[0];
        trial.hold = true;
        trial.start = experiment::StartState::equilibrium;
        trial.constant_commands = {{"upper", 0.004}};
    }));
    const Result<inverse::ActuationProblem> problem = actuation_problem(setup, slow_signals());
    ASSERT_TRUE(problem) << problem.error().text();
    const inverse::ActuationEvaluation slack = inverse::evaluate_actuation(*problem, MatrixXd::Zero(1, 1));
    ASSERT_TRUE(slack.ok()) << slack.message;
    EXPECT_EQ(slack.gradient(0), 0.0);
    const Optimization found = search_signals(setup, *problem, slow_signals(), first_values(setup, problem->sought));
    ASSERT_TRUE(found.usable()) << found.fit.message;
    EXPECT_NEAR(found.fit.values(0), 0.004, 4e-5);
}

/// A hold has one value of each signal: the constant tension of the pose, found from none.
TEST(OptimizeCommands, FindsTheTensionOfAHold) {
    const test::Folder folder("commands_hold");
    setup::Setup setup = recorded(test::chambered_beam(folder, 0.1, [](experiment::Experiment& e) {
        e.chambers.clear();
        e.tendons.push_back(test::upper_tendon());
        experiment::TrialDeclaration& trial = e.trials[0];
        trial.hold = true;
        trial.start = experiment::StartState::equilibrium;
        trial.constant_commands = {{"upper", 1.2}};
    }));
    const Result<inverse::ActuationProblem> problem = actuation_problem(setup, slow_signals());
    ASSERT_TRUE(problem) << problem.error().text();
    ASSERT_TRUE(problem->sought.constant);
    const Optimization found = optimize_with_chosen_steps(setup, *problem, slow_signals(),
                                                          MatrixXd(MatrixXd::Zero(1, 1)));
    ASSERT_TRUE(found.usable()) << found.fit.message;
    EXPECT_TRUE(found.fit.converged()) << found.fit.message;
    ASSERT_EQ(found.fit.values.size(), 1);
    EXPECT_NEAR(found.fit.values(0), 1.2, 0.01);
    EXPECT_TRUE(found.miss.reached);
    EXPECT_TRUE(found.deviations.found) << found.deviations.reason;
    const prediction::SetupRun again = run_with_found_signals(setup, found);
    EXPECT_NEAR(again.fit_rms_m, found.after.fit_rms_m, 1e-9);
    test::record("tension_N", std::vector<double>{found.fit.values(0), found.deviations.deviations(0)});
}

/// A signal that is not sought stays as the trial has it, whether by its declaration or as another one is named.
TEST(OptimizeCommands, SeeksOnlyWhatIsAskedFor) {
    const test::Folder folder("commands_asked");
    setup::Setup setup = driven_beam(folder, {});
    const fibre::Signal pressure = setup::actuator_signal(setup.experiment, setup.trials[0].model, 0);
    setup.experiment.chambers[0].sought = false;
    OptimizeSettings settings = slow_signals();
    settings.max_evaluations = 3;
    Result<inverse::ActuationProblem> problem = actuation_problem(setup, settings);
    ASSERT_TRUE(problem) << problem.error().text();
    ASSERT_EQ(problem->sought.signals.size(), 1u);
    EXPECT_EQ(problem->sought.signals[0].name, "cable");
    ASSERT_EQ(problem->sought.groups.size(), 2u);
    // Away from a tension of zero, where the thread is slack at one side.
    const MatrixXd start = first_values(setup, problem->sought).array() + 0.2;
    const inverse::ActuationEvaluation at = inverse::evaluate_actuation(*problem, start);
    ASSERT_TRUE(at.ok()) << at.message;
    MatrixXd there = start, back = start;
    there(0, 1) += 1e-4, back(0, 1) -= 1e-4;
    const double slope = (inverse::evaluate_actuation(*problem, there).loss_m2 -
                          inverse::evaluate_actuation(*problem, back).loss_m2) /
                         2e-4;
    EXPECT_NE(slope, 0.0);
    EXPECT_NEAR(at.gradient(0, 1), slope, 1e-4 * std::abs(slope)) << "beside a signal that is kept";
    const Optimization found = search_signals(setup, *problem, settings, start);
    ASSERT_TRUE(found.usable()) << found.fit.message;
    EXPECT_EQ(found_commands(problem->sought, found.fit.values)[0], pressure);
    EXPECT_LT(found.fit.best.loss_m2, at.loss_m2);
    // By its name it is sought in spite of the declaration.
    const auto named = sought_items({"signals:upper"}, setup.experiment);
    ASSERT_TRUE(named) << named.error().text();
    settings.seek = *named;
    problem = actuation_problem(setup, settings);
    ASSERT_TRUE(problem) << problem.error().text();
    ASSERT_EQ(problem->sought.signals.size(), 1u);
    EXPECT_EQ(problem->sought.signals[0].name, "upper");
    setup.experiment.tendons[0].sought = false;
    settings.seek = {{SoughtKind::signals}};
    problem = actuation_problem(setup, settings);
    ASSERT_FALSE(problem);
    EXPECT_NE(problem.error().what.find("no signal is left"), std::string::npos) << problem.error().text();
    EXPECT_FALSE(sought_items({"signals:other"}, setup.experiment));
}

TEST(OptimizeCommands, KeepsToTheLimits) {
    const test::Folder folder("commands_limits");
    setup::Setup setup = driven_beam(folder, {});
    EXPECT_NEAR(command_bounds(setup, 0).scale, 3.0 * 1.5 * 9000.0, 1e-9);
    setup.experiment.limits.pressure_Pa = 8000.0;
    EXPECT_EQ(command_bounds(setup, 0).upper, 8000.0);
    EXPECT_EQ(command_bounds(setup, 0).lower, 0.0);
    setup.command_ranges[0].lowest = -100.0;
    EXPECT_EQ(command_bounds(setup, 0).lower, -8000.0);
    setup.experiment.limits.pressure_Pa = 2e5;
    EXPECT_EQ(command_bounds(setup, 0).lower, -101325.0) << "no less than vacuum";
    setup.command_ranges = {{}, {}};
    EXPECT_EQ(command_bounds(setup, 1).lower, 0.0) << "a tendon never pushes";
    EXPECT_EQ(command_bounds(setup, 1).upper, 1e4);
    OptimizeSettings settings;
    EXPECT_EQ(lowest_activation(setup.experiment, settings), 0.5);
    setup.experiment.limits.activation = 0.7;
    EXPECT_EQ(lowest_activation(setup.experiment, settings), 0.7);
    settings.lowest = 0.6;
    EXPECT_EQ(lowest_activation(setup.experiment, settings), 0.6);
}

}  // namespace
}  // namespace myo::calibration
