#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "prediction/parameter_tangent.hpp"
#include "prediction/prediction.hpp"
#include "setup/actuator_signals.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"

namespace myo::prediction {
namespace {

using experiment::Experiment;

/// Signal of the chamber in the model that a trial is simulated with.
fibre::Signal pressure_of(const setup::Setup& setup, std::size_t trial) {
    return *affected_trial(setup, trial, declared_values(setup)).model.force_elements.front()->command();
}

TEST(ChamberSignals, AreConstantsStepsAndPassiveWhereNoTrialNamesThem) {
    const test::Folder folder("chamber_signals");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [](Experiment& e) {
        e.trials[0].constant_commands = {{"upper", 3000.0}};
        e.trials[0].start = experiment::StartState::equilibrium;
        e.trials.push_back(e.trials[1]);
        e.trials[1].actuation_steps = {{"upper", -2000.0}};
    });
    ASSERT_EQ(setup.chambers.size(), 1u);
    EXPECT_NEAR(setup.chambers[0].volume_m3, 70e-3 * 18e-3 * 8e-3, 1e-14);
    EXPECT_EQ(setup.chambers[0].volume_factor, 1.0);
    EXPECT_EQ(pressure_of(setup, 0), fibre::Signal::constant(3000.0));
    EXPECT_EQ(pressure_of(setup, 1).value_before(0.0), 0.0);
    EXPECT_EQ(pressure_of(setup, 1).value(0.0), -2000.0);
    EXPECT_EQ(pressure_of(setup, 2), fibre::Signal::constant(0.0));
    // The body rests under the constant pressure, away from where it rests without it.
    const TrialPrediction held = predict_trial(setup, 0, declared_values(setup));
    ASSERT_TRUE(held.ok()) << held.message;
    const Eigen::Matrix3Xd& tip = held.positions_m[0];
    EXPECT_LT((tip.rightCols(1) - tip.leftCols(1)).norm(), 1e-6);
    const double grown = setup::chamber_volume(*setup.body, setup.chambers[0], held.trace.positions.front()) /
                         setup.chambers[0].volume_m3;
    EXPECT_GT(grown, 1.01);
}

TEST(ChamberSignals, RespondToEffectsOnTheActuation) {
    const test::Folder folder("chamber_effects");
    const auto with = [&](const std::string& id, effect::EffectParameters parameters) {
        const setup::Setup setup = test::chambered_beam(folder, 0.1, [&](Experiment& e) {
            e.trials[0].actuation_steps = {{"upper", 4000.0}};
            e.effects = {{id, std::move(parameters)}};
        });
        return pressure_of(setup, 0);
    };
    const double t = 0.04;
    EXPECT_NEAR(with("actuation_lag", {{"time_constant_s", 0.05}}).value(t), 4000.0 * (1.0 - std::exp(-t / 0.05)), 2.0);
    EXPECT_NEAR(with("actuation_leak", {{"time_constant_s", 0.05}}).value(t), 4000.0 * std::exp(-t / 0.05), 2.0);
    EXPECT_EQ(with("actuation_delay", {{"delay_s", 0.03}}).value(0.02), 0.0);
    EXPECT_NEAR(with("actuation_delay", {{"delay_s", 0.03}}).value(0.09), 4000.0, 1e-9);
    EXPECT_NEAR(with("actuation_gain", {{"relative_change", 0.1}}).value(t), 4400.0, 1e-9);
    EXPECT_NEAR(with("actuation_hysteresis", {{"fraction", 0.5}, {"width", 2000.0}}).value(t),
                2000.0 + 0.5 * 2000.0 * (1.0 - std::exp(-2.0)), 1e-6);
    const std::string upper = "upper", other = "other";
    EXPECT_NEAR(with("actuation_gain", {{"relative_change", 0.1}, {"signal", upper}}).value(t), 4400.0, 1e-9);
    EXPECT_EQ(with("actuation_gain", {{"relative_change", 0.1}, {"signal", other}}).value(t), 4000.0);
}

/// Range and scale of a width are those of the pressures, and probes see them.
TEST(ChamberSignals, ScaleTheWidthOfAHysteresis) {
    const test::Folder folder("chamber_width");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [](Experiment& e) {
        e.trials[0].actuation_steps = {{"upper", 4000.0}};
    });
    const effect::EffectDeclaration declared{"actuation_hysteresis", {{"fraction", 0.1}, {"width", 500.0}}};
    const std::vector<ModelParameter> parameters = effect_parameters(setup, declared, 0);
    ASSERT_EQ(parameters.size(), 2u);
    EXPECT_NEAR(parameters[1].parameter.scale, 0.05 * 4000.0, 1e-9);
    EXPECT_NEAR(parameters[1].parameter.upper, 10.0 * 4000.0, 1e-9);
}

/// The derivative of the prediction by a free pressure against differences of runs, for start values of zero and above.
TEST(ChamberLevels, HaveTheTangentOfTheWholeRun) {
    const test::Folder folder("chamber_level");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [](Experiment& e) {
        e.trials[0].actuation_steps = {{"upper", std::nullopt}};
        e.material.calibrate = {"actuation_level"};
    });
    const std::vector<ModelParameter> parameters = free_parameters(setup);
    ASSERT_EQ(parameters.size(), 1u);
    EXPECT_EQ(parameters[0].parameter.name, "actuation_level.swing.upper");
    EXPECT_EQ(parameters[0].unit, "Pa");
    EXPECT_EQ(parameters[0].parameter.value, 0.0);
    std::vector<double> errors;
    for (const double level : {0.0, 5000.0}) {
        ParameterValues values = declared_values(setup);
        set_value(parameters[0], level, values);
        const TrialPrediction there = predict_trial(setup, 0, values, parameters);
        ASSERT_TRUE(there.ok()) << there.message;
        const auto tip_at = [&](double pressure) {
            ParameterValues changed = values;
            set_value(parameters[0], pressure, changed);
            return predict_trial(setup, 0, changed).residual_m[0];
        };
        const double step = 100.0;
        const Eigen::Matrix3Xd wide = (tip_at(level + step) - tip_at(level - step)) / (2.0 * step),
                               narrow = (tip_at(level + 0.5 * step) - tip_at(level - 0.5 * step)) / step;
        const Eigen::Matrix3Xd exact = (4.0 * narrow - wide) / 3.0;
        EXPECT_GT(exact.norm(), 1e-8);
        errors.push_back((there.tangents[0][0] - exact).norm() / exact.norm());
        EXPECT_LT(errors.back(), 1e-5);
    }
    test::record("relative_errors", errors);
}

}  // namespace
}  // namespace myo::prediction
