#include "prediction/time_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/numerical_damping.hpp"
#include "support/swung_beam.hpp"

namespace myo::prediction {
namespace {

/// The beam of 7.3 Hz let go under gravity, with another modulus and damping, filmed at 100 Hz.
setup::TrialStep chosen(double modulus_factor, double damping_s) {
    const test::Folder folder("time_step");
    const setup::Setup setup = test::swung_beam(folder, 0.3);
    ParameterValues values = declared_values(setup);
    values.youngs_modulus_Pa *= modulus_factor;
    values.damping_s = damping_s;
    const std::vector<setup::TrialStep> steps = choose_steps(setup, values);
    EXPECT_EQ(steps.size(), setup.trials.size());
    return steps.front();
}

double whole_share(double h_s) { return std::abs(0.01 / h_s - std::round(0.01 / h_s)); }

TEST(TimeStep, ResolvesTheVibrationThatATrialShows) {
    for (const double factor : {1.0, 4.0, 30.0}) {
        const setup::TrialStep step = chosen(factor, 1e-4);
        const double first_Hz = 7.33 * std::sqrt(factor);
        EXPECT_NEAR(step.vibration_Hz, first_Hz, 0.06 * first_Hz) << factor;  // about the sagging pose, on coarse cells
        EXPECT_LE(step.frequency_error, 1.001e-3) << factor;
        EXPECT_GT(step.frequency_error, 0.3e-3) << factor;  // and no shorter than that
        EXPECT_LT(whole_share(step.h_s), 1e-9) << step.h_s;
        EXPECT_LE(step.h_s, 0.005);
    }
}

/// Long steps of a scheme that damps what it does not resolve show nothing of a vibration.
TEST(TimeStep, ResolvesAVibrationThatIsMuchFasterThanTheCamera) {
    const test::Folder folder("fast_step");
    setup::Setup setup = test::swung_beam(folder, 0.1);
    setup.noise_m.setConstant(1e-7);
    ParameterValues values = declared_values(setup);
    values.youngs_modulus_Pa *= 3000.0;
    values.damping_s = 2e-5;
    const double first_Hz = 7.33 * std::sqrt(3000.0);
    const setup::TrialStep step = choose_steps(setup, values).front();
    EXPECT_NEAR(step.vibration_Hz, first_Hz, 0.05 * first_Hz);
    EXPECT_LE(step.frequency_error, 1.001e-3);
    run_with_chosen_steps(setup, values);
    EXPECT_NEAR(setup.trials.front().options.h_s, step.h_s, 0.15 * step.h_s);
}

/// A run that looks at its own vibrations ends with the steps that are chosen for them.
TEST(TimeStep, OfARunSuitsTheVibrationsThatItShows) {
    const test::Folder folder("run_step");
    setup::Setup setup = test::swung_beam(folder, 0.3);
    ParameterValues values = declared_values(setup);
    values.youngs_modulus_Pa *= 30.0;
    values.damping_s = 1e-4;
    const double chosen_s = choose_steps(setup, values).front().h_s;
    const SetupRun run = run_with_chosen_steps(setup, values);
    ASSERT_TRUE(run.ok());
    EXPECT_LT(chosen_s, 0.001);
    EXPECT_NEAR(setup.trials.front().options.h_s, chosen_s, 0.15 * chosen_s);
    EXPECT_GE(run.predictions.front().trace.times_s.size(), static_cast<std::size_t>(0.3 / chosen_s));
    setup.settings.h_s = 0.005;  // as a person asked for
    setup::set_step(setup.trials.front(), 0.005);
    run_with_chosen_steps(setup, values);
    EXPECT_EQ(setup.trials.front().options.h_s, 0.005);
}

/// A run that is there already shows the vibration; no other is made, which could not be here.
TEST(TimeStep, FollowsFromAKnownRun) {
    const test::Folder folder("known_step");
    setup::Setup setup = test::swung_beam(folder, 0.3);
    ParameterValues values = declared_values(setup);
    values.youngs_modulus_Pa *= 4.0;
    const double chosen_s = choose_steps(setup, values).front().h_s;
    const SetupRun run = run_trials(setup, values);
    ASSERT_TRUE(run.ok());
    setup.trials.front().options.max_iterations = 1;
    ASSERT_NE(choose_steps(setup, values).front().failure, "");
    const setup::TrialStep step = choose_steps(setup, values, {}, &run).front();
    EXPECT_EQ(step.failure, "");
    EXPECT_NEAR(step.h_s, chosen_s, 0.15 * chosen_s);
    EXPECT_LT(step.h_s, setup.trials.front().options.h_s);
    EXPECT_LE(step.frequency_error, 1.001e-3);
}

/// A step that is right for the first vibration turns the faster ones too slowly; the estimate of what that does to the
/// traces is held against a run with steps of a tenth.
TEST(TimeStep, KnowsWhatItDoesToFasterVibrations) {
    const test::Folder folder("other_vibrations");
    setup::Setup setup = test::swung_beam(folder, 0.3);
    setup.noise_m.setConstant(1e-7);
    ParameterValues values = declared_values(setup);
    values.damping_s = 1e-6;  // they last
    const auto run = [&](double h_s) {
        setup::set_step(setup.trials.front(), h_s);
        return predict_trial(setup, 0, values);
    };
    const TrialPrediction fine = run(1.25e-4), coarse = run(1.25e-3);
    const setup::TrialStep seen = step_seen_in(setup, 0, values, coarse.trace);
    std::vector<Eigen::Matrix3Xd> differences;
    for (std::size_t m = 0; m < fine.residual_m.size(); ++m)
        differences.push_back(coarse.residual_m[m] - fine.residual_m[m]);
    // Errors grow from 0 at the start, so that their rms over the trial is a third of what they are at its end.
    const double first_m = seen.vibration_m * seen.frequency_error * 2.0 * M_PI * seen.vibration_Hz * 0.3;
    const double estimate = std::hypot(seen.other_vibrations_m, first_m), actual = rms(differences);
    EXPECT_GT(seen.other_vibrations_m, 2.0 * first_m);
    EXPECT_GT(estimate, 0.7 * actual);
    EXPECT_LT(estimate, 4.0 * actual);
}

/// What creeps to its rest needs no short steps, however stiff the body.
TEST(TimeStep, IsHalfAnIntervalWhereNothingSwings) {
    const setup::TrialStep step = chosen(30.0, 0.2);
    EXPECT_EQ(step.vibration_Hz, 0.0);
    EXPECT_NEAR(step.h_s, 0.005, 0.003);
    EXPECT_LT(step.trace_error_m, 1e-4 / 3.0);
}

/// Where no vibration is seen, the error follows from two runs (Richardson); it is compared with the difference to a
/// run with a step of a tenth. The fast components of the release are stiff, so that the order is not yet exactly two.
TEST(TimeStep, StatesTheErrorOfAMotionThatCreeps) {
    const test::Folder folder("creeping");
    setup::Setup setup = test::swung_beam(folder, 0.3);
    ParameterValues values = declared_values(setup);
    values.damping_s = 0.1;
    const setup::TrialStep step = choose_steps(setup, values).front();
    ASSERT_EQ(step.vibration_Hz, 0.0);
    const auto run = [&](double h_s) {
        setup::set_step(setup.trials.front(), h_s);
        return predict_trial(setup, 0, values);
    };
    const double actual_m = rms_between(run(step.h_s), run(0.1 * step.h_s));
    EXPECT_GT(step.trace_error_m, 0.7 * actual_m);
    EXPECT_LT(step.trace_error_m, 2.0 * actual_m);
}

}  // namespace
}  // namespace myo::prediction
