#include "prediction/run_trials.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "prediction/level_curve.hpp"
#include "prediction/parameter_tangent.hpp"
#include "prediction/predict_trials.hpp"
#include "prediction/shorter_steps.hpp"
#include "support/known_run.hpp"
#include "support/muscle_beam.hpp"

namespace myo::prediction {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

TEST(Rms, CountsFiniteCoordinatesOnly) {
    Eigen::Matrix3Xd a(3, 2), b(3, 1);
    a << 3.0, missing, 0.0, missing, 0.0, missing;
    b << 4.0, 0.0, 0.0;
    EXPECT_NEAR(rms({a}), 3.0 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(rms({a, b}), 5.0 / std::sqrt(6.0), 1e-15);
    EXPECT_TRUE(std::isnan(rms({a.rightCols(1)})));
    EXPECT_TRUE(std::isnan(rms({})));
}

class Scores : public testing::Test {
protected:
    Scores() : folder_("scores"), setup_(test::swung_beam(folder_, 0.2)) {}

    test::Folder folder_;
    setup::Setup setup_;
};

TEST_F(Scores, OfAConstantMissAreThatMiss) {
    const TrialPrediction prediction = test::missed_by(setup_, 0, {1e-3, 2e-3, -2e-3});
    const TrialScore scored = score(setup_, 0, prediction);
    EXPECT_EQ(scored.name, "swing");
    EXPECT_EQ(scored.role, experiment::TrialRole::fit);
    EXPECT_NEAR(scored.rms_m, std::sqrt(3.0) * 1e-3, 1e-15);
    ASSERT_EQ(scored.markers.size(), 4u);
    EXPECT_EQ(scored.markers[3].name, "middle");
    EXPECT_NEAR(scored.markers[3].steady_error_m, 3e-3, 1e-15);
    EXPECT_LT((scored.markers[3].steady_measured_m - Eigen::Vector3d(0.05, 0.015, 0.03)).norm(), 1e-15);
    EXPECT_LT((scored.markers[3].steady_simulated_m - Eigen::Vector3d(0.051, 0.017, 0.028)).norm(), 1e-15);
}

/// The steady state is the last fifth: 4 of 21 samples.
TEST_F(Scores, SteadyStateIsTheLastFifth) {
    TrialPrediction prediction = test::missed_by(setup_, 0, Eigen::Vector3d::Zero());
    ASSERT_EQ(prediction.residual_m[0].cols(), 21);
    prediction.residual_m[0].leftCols(17).setConstant(1.0);
    EXPECT_EQ(score(setup_, 0, prediction).markers[0].steady_error_m, 0.0);
    prediction.residual_m[0](1, 17) = 4e-3;
    EXPECT_NEAR(score(setup_, 0, prediction).markers[0].steady_error_m, 1e-3, 1e-17);
    // Occluded samples are left out of the mean.
    prediction.residual_m[0].col(18).setConstant(missing);
    prediction.residual_m[0].col(19).setConstant(missing);
    EXPECT_NEAR(score(setup_, 0, prediction).markers[0].steady_error_m, 2e-3, 1e-17);
    prediction.residual_m[0].rightCols(4).setConstant(missing);
    EXPECT_TRUE(std::isnan(score(setup_, 0, prediction).markers[0].steady_error_m));
}

TEST_F(Scores, OfDisplacementsAreMeasuredFromTheReference) {
    for (const Eigen::Matrix3Xd& track : setup_.trials[0].measured.tracks)
        setup_.trials[0].reference_m.emplace_back(track.col(0) - Eigen::Vector3d(0.0, 0.0, 5e-3));
    const TrialScore scored = score(setup_, 0, test::missed_by(setup_, 0, {1e-3, 0.0, 0.0}));
    EXPECT_LT((scored.markers[0].steady_measured_m - Eigen::Vector3d(0.0, 0.0, 5e-3)).norm(), 1e-15);
    EXPECT_LT((scored.markers[0].steady_simulated_m - Eigen::Vector3d(1e-3, 0.0, 5e-3)).norm(), 1e-15);
}

TEST_F(Scores, RunPoolsTrialsByRole) {
    const SetupRun run = test::run_missed_by(setup_, {{3e-3, 0.0, 0.0}, {0.0, 6e-3, 0.0}});
    EXPECT_TRUE(run.ok());
    EXPECT_NEAR(run.fit_rms_m, 3e-3 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(run.validation_rms_m, 6e-3 / std::sqrt(3.0), 1e-15);
    setup_.trials[1].role = experiment::TrialRole::fit;
    const SetupRun both = test::run_missed_by(setup_, {{3e-3, 0.0, 0.0}, {0.0, 6e-3, 0.0}});
    EXPECT_NEAR(both.fit_rms_m, std::sqrt(0.5 * (9e-6 + 36e-6) / 3.0), 1e-15);
    EXPECT_TRUE(std::isnan(both.validation_rms_m));
}

TEST_F(Scores, FailedTrialIsNamedAndNotPooled) {
    const SetupRun run = test::with_failure(setup_, test::run_missed_by(setup_, {{1e-3, 0.0, 0.0}, {1e-3, 0.0, 0.0}}),
                                            0, "it broke");
    EXPECT_FALSE(run.ok());
    EXPECT_EQ(run.failure, "trial swing: it broke");
    EXPECT_EQ(run.scores.size(), 1u);
    EXPECT_TRUE(std::isnan(run.fit_rms_m));
    EXPECT_NEAR(run.validation_rms_m, 1e-3 / std::sqrt(3.0), 1e-15);
    EXPECT_FALSE(all_ok(run.predictions));
}

TEST_F(Scores, DifferenceOfTwoPredictionsIsThatOfTheirMisses) {
    const TrialPrediction a = test::missed_by(setup_, 0, {1e-3, 0.0, 0.0}),
                          b = test::missed_by(setup_, 0, {1e-3, 0.0, 6e-3});
    EXPECT_NEAR(rms_between(a, b), 6e-3 / std::sqrt(3.0), 1e-15);
    EXPECT_EQ(rms_between(a, a), 0.0);
}

TEST_F(Scores, TrialsAreFoundByRole) {
    EXPECT_EQ(trials_with_role(setup_, experiment::TrialRole::fit), std::vector<std::size_t>{0});
    EXPECT_EQ(trials_with_role(setup_, experiment::TrialRole::validate), std::vector<std::size_t>{1});
}

TEST_F(Scores, StepsOnlyBecomeShorter) {
    const double h = setup_.trials[0].options.h_s;
    std::vector<setup::TrialStep> steps(2);
    steps[0].h_s = 0.86 * h;
    steps[1].h_s = 3.0 * h;
    EXPECT_FALSE(much_shorter(setup_, steps));
    steps[0].h_s = 0.84 * h;
    EXPECT_TRUE(much_shorter(setup_, steps));
    set_shorter_steps(setup_, steps);
    EXPECT_EQ(setup_.trials[0].options.h_s, 0.84 * h);
    EXPECT_EQ(setup_.trials[1].options.h_s, h);
    ASSERT_EQ(setup_.steps.size(), 2u);
    EXPECT_EQ(setup_.steps[1].h_s, h);
}

TEST_F(Scores, ParametersAreStoredWhereTheyAreRead) {
    const std::vector<ModelParameter> parameters = free_parameters(setup_, {"youngs_modulus", "damping"});
    ASSERT_EQ(parameters.size(), 2u);
    ParameterValues values = declared_values(setup_);
    EXPECT_EQ(value_of(parameters[0], values), 2.6e5);
    EXPECT_EQ(value_of(parameters[1], values), 0.004);
    set_value(parameters[0], 3e5, values);
    set_value(parameters[1], 0.007, values);
    EXPECT_EQ(values.youngs_modulus_Pa, 3e5);
    EXPECT_EQ(values.damping_s, 0.007);
    using Kind = ModelParameter::Kind;
    for (const Kind kind : {Kind::translation, Kind::rotation, Kind::start_shift})
        for (std::size_t i = 0; i < 2; ++i) {
            ModelParameter p;
            p.kind = kind;
            p.index = p.trial = i;
            EXPECT_EQ(value_of(p, values), 0.0);
            set_value(p, 0.25 + static_cast<double>(i), values);
            EXPECT_EQ(value_of(p, values), 0.25 + static_cast<double>(i));
        }
    EXPECT_EQ(values.translation_m, Eigen::Vector3d(0.25, 1.25, 0.0));
    EXPECT_EQ(values.rotation_rad, Eigen::Vector3d(0.25, 1.25, 0.0));
    EXPECT_EQ(values.start_shift_s, (std::vector<double>{0.25, 1.25}));
}

TEST_F(Scores, DifferenceStepsFollowTheScale) {
    std::vector<ModelParameter> parameters = free_parameters(setup_, {"youngs_modulus", "damping"});
    for (ModelParameter& p : parameters) {
        p.parameter.scale = 2.0;
        p.parameter.over_decades = false;
        EXPECT_EQ(difference_step(p, 1e3, 0.01), 0.02);
    }
}

TEST_F(Scores, ModelHasTheValues) {
    ParameterValues values = declared_values(setup_);
    values.youngs_modulus_Pa = 3e5;
    values.damping_s = 0.01;
    setup_.modulus_factor = 0.9;
    const model::Model model = trial_model(setup_, 0, values);
    EXPECT_EQ(model.damping_s, 0.01);
    // E = 2 mu (1 + nu) with nu = 0.49.
    EXPECT_NEAR(2.0 * 1.49 * model.moduli.front().mu, 0.9 * 3e5, 1e-6);
    EXPECT_NEAR(3.0 * 0.02 * model.moduli.front().kappa, 0.9 * 3e5, 1e-6);
}

TEST(LevelCurve, IsALineThroughPassiveForOnePoint) {
    EXPECT_EQ(curve_through({2.0}, {1.5}, 0.0, 1.0), 1.0);
    EXPECT_EQ(curve_through({2.0}, {1.5}, 4.0, 1.0), 2.0);
    EXPECT_EQ(curve_through({0.0}, {1.5}, 4.0, 1.0), 1.5);
}

TEST(LevelCurve, IsExtrapolatedWithTheOuterSecants) {
    const std::vector<double> x{0.0, 1.0, 3.0}, y{0.0, 1.0, 7.0};
    EXPECT_NEAR(curve_through(x, y, -2.0, 0.0), -2.0, 1e-15);
    EXPECT_NEAR(curve_through(x, y, 4.0, 0.0), 10.0, 1e-14);
}

/// Closed form of Fritsch and Butland: at x = 1 the slope is the harmonic mean of 1 and 3 with weights 5 and 4,
/// 9 / (5 / 1 + 4 / 3) = 27 / 19; the Hermite cubic follows.
TEST(LevelCurve, HasTheSlopesOfFritschAndButland) {
    const std::vector<double> x{0.0, 1.0, 3.0}, y{0.0, 1.0, 7.0};
    const double inner = 27.0 / 19.0;
    // Left half interval: y = 1/2 + (1 - inner) / 8; right: width 2, y = 4 + 2 (inner - 3) / 8.
    EXPECT_NEAR(curve_through(x, y, 0.5, 0.0), 0.5 + (1.0 - inner) / 8.0, 1e-15);
    EXPECT_NEAR(curve_through(x, y, 2.0, 0.0), 4.0 + (inner - 3.0) / 4.0, 1e-14);
}

TEST(LevelCurve, StaysWithinItsPointsAndIsFlatAtAnExtremum) {
    const std::vector<double> x{0.0, 1.0, 2.0, 5.0}, y{0.0, 2.0, 1.0, 1.0};
    for (double at = 0.0; at <= 5.0; at += 0.05) {
        EXPECT_LE(curve_through(x, y, at, 0.0), 2.0 + 1e-14);
        EXPECT_GE(curve_through(x, y, at, 0.0), -1e-14);
        if (at > 2.0) {
            EXPECT_NEAR(curve_through(x, y, at, 0.0), 1.0, 1e-14);
        }
    }
    const double near = curve_through(x, y, 1.0 - 1e-5, 0.0);
    EXPECT_NEAR(near, 2.0, 1e-9);
}

/// Free levels of a predicted trial: from a shared test condition, else the mean.
TEST(PredictedLevels, FollowTheCondition) {
    const test::Folder folder("predicted_levels");
    setup::Setup setup = test::swung_beam(folder, 0.1);
    setup.trials.push_back(setup.trials[0]);
    setup.experiment.trials.push_back(setup.experiment.trials[0]);
    setup.trials.push_back(setup.trials[0]);
    setup.experiment.trials.push_back(setup.experiment.trials[0]);
    ParameterValues values = declared_values(setup);
    values.levels = {{{0, 1.2}}, {{0, 1.0}}, {{0, 1.6}}, {{0, 1.4}}};
    EXPECT_NEAR(with_predicted_levels(setup, values).levels[1].at(0), (1.2 + 1.6 + 1.4) / 3.0, 1e-15);
    const double pressures[] = {100.0, 150.0, 200.0, 200.0};
    for (std::size_t t = 0; t < 4; ++t) setup.experiment.trials[t].condition["pressure"] = pressures[t];
    // Two trials at 200: their mean is 1.5, and half way from 1.2 the line gives 1.35.
    const ParameterValues predicted = with_predicted_levels(setup, values);
    EXPECT_NEAR(predicted.levels[1].at(0), 1.35, 1e-15);
    EXPECT_EQ(predicted.levels[0].at(0), 1.2);
    setup.experiment.trials[2].condition.clear();
    EXPECT_NEAR(with_predicted_levels(setup, values).levels[1].at(0), 1.4, 1e-15);
}

}  // namespace
}  // namespace myo::prediction
