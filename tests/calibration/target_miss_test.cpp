#include "calibration/target_miss.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/known_run.hpp"
#include "support/made_calibration.hpp"
#include "support/swung_beam.hpp"

namespace myo::calibration {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// One trial of 11 samples, 10 ms apart, with a noise of 0.1 mm.
class MissedTarget : public testing::Test {
protected:
    MissedTarget() : folder_("missed_target"), setup_(test::swung_beam(folder_, 0.1)) { setup_.trials.resize(1); }

    /// A run whose residuals are zero but for what the test sets.
    prediction::SetupRun run(const prediction::TrialPrediction& prediction) const {
        return prediction::scored_run(setup_, prediction::declared_values(setup_), {prediction}, {0});
    }
    prediction::TrialPrediction met() const { return test::missed_by(setup_, 0, Eigen::Vector3d::Zero()); }

    test::Folder folder_;
    setup::Setup setup_;
};

TEST_F(MissedTarget, IsReachedUpToThreeTimesTheNoise) {
    // rms over three coordinates: a shift of s along an axis has s / sqrt(3).
    const double three = 3.0 * 1e-4 * std::sqrt(3.0);
    const TargetMiss near = target_miss(setup_, run(test::missed_by(setup_, 0, {0.999 * three, 0.0, 0.0})));
    EXPECT_TRUE(near.reached);
    EXPECT_NEAR(near.noise_m, 1e-4, 1e-18);
    EXPECT_NEAR(near.noise_levels, 2.997, 1e-9);
    const TargetMiss far = target_miss(setup_, run(test::missed_by(setup_, 0, {1.001 * three, 0.0, 0.0})));
    EXPECT_FALSE(far.reached);
    EXPECT_NEAR(far.rms_m, 1.001 * 3e-4, 1e-15);
}

TEST_F(MissedTarget, NamesTheWorstMarkersFirst) {
    prediction::TrialPrediction prediction = met();
    const double shifts[] = {1e-3, 4e-3, 2.1e-3, 1.9e-3};
    for (std::size_t m = 0; m < 4; ++m) prediction.residual_m[m].row(2).setConstant(shifts[m]);
    const TargetMiss miss = target_miss(setup_, run(prediction));
    // Markers with at least half of the largest error are named.
    ASSERT_EQ(miss.markers.size(), 2u);
    EXPECT_EQ(miss.markers[0].name, "tip_right");
    EXPECT_EQ(miss.markers[1].name, "tip_low");
    EXPECT_NEAR(miss.markers[0].rms_m, 4e-3 / std::sqrt(3.0), 1e-15);
    TargetRule all;
    all.near_worst = 0.0;
    EXPECT_EQ(target_miss(setup_, run(prediction), all).markers.size(), 3u);
}

TEST_F(MissedTarget, NamesTheTimesAroundTheWorst) {
    prediction::TrialPrediction prediction = met();
    for (std::size_t m = 0; m < 4; ++m) {
        Eigen::Matrix3Xd& r = prediction.residual_m[m];
        r.row(0).segment(4, 4).setConstant(2e-3);  // 0.04 to 0.07 s
        r(0, 6) = 3e-3;
        r.col(5).setConstant(std::nan(""));  // occluded in between
        r(0, 9) = 2e-3;                      // apart
    }
    const TargetMiss miss = target_miss(setup_, run(prediction));
    EXPECT_NEAR(miss.worst_s, 0.06, 1e-15);
    EXPECT_NEAR(miss.worst_rms_m, 3e-3 / std::sqrt(3.0), 1e-15);
    EXPECT_NEAR(miss.from_s, 0.04, 1e-15);
    EXPECT_NEAR(miss.until_s, 0.07, 1e-15);
    EXPECT_THAT(sentence(miss, 5e-3), HasSubstr("rms of 5 mm are left"));
    EXPECT_THAT(sentence(miss, 5e-3), HasSubstr("most from 0.04 s to 0.07 s (1.73 mm at 0.06 s)"));
}

TEST_F(MissedTarget, StartCountsFromFiveTimesTheNoise) {
    inverse::ActuationProblem problem;
    problem.sought.frequency_Hz = 20.0;
    const auto found = [&](double levels) {
        prediction::TrialPrediction prediction = met();
        for (Eigen::Matrix3Xd& r : prediction.residual_m) r(1, 0) = levels * 1e-4 * std::sqrt(3.0);
        return start_miss(setup_, problem, run(prediction));
    };
    EXPECT_FALSE(found(4.99).has_value());
    ASSERT_TRUE(found(5.01).has_value());
    EXPECT_THAT(*found(6.0), StartsWith("the target does not begin where the body rests: at t = 0 s its markers are "
                                        "0.6 mm rms away, 6 times the noise; "));
    EXPECT_THAT(*found(6.0), HasSubstr("start = \"equilibrium\" seeks it"));
    problem.sought.from_before = true;
    EXPECT_THAT(*found(6.0), HasSubstr("taken from the record"));
    problem.sought.seek_before = true;
    EXPECT_THAT(*found(6.0), HasSubstr("no level held before t = 0 brings them there"));
}

TEST_F(MissedTarget, LevelIsOnRecordByFileStepOrSignal) {
    experiment::Experiment experiment = setup_.experiment;
    experiment.muscles.resize(2);
    experiment.muscles[0].name = "up";
    experiment.muscles[1].name = "down";
    experiment::TrialDeclaration trial = experiment.trials[0];
    EXPECT_FALSE(level_is_on_record(experiment, trial, 0));
    trial.actuation_steps = {{"down", 0.9}};
    EXPECT_FALSE(level_is_on_record(experiment, trial, 0));
    EXPECT_TRUE(level_is_on_record(experiment, trial, 1));
    experiment.muscles[0].signal = fibre::Signal::constant(1.0);
    EXPECT_TRUE(level_is_on_record(experiment, trial, 0));
    experiment.muscles[0].signal.reset();
    trial.actuation = "a.csv";
    EXPECT_TRUE(level_is_on_record(experiment, trial, 0));
}

TEST(MadeCalibration, DeviationAddsSquaresOfKnownParts) {
    const test::Folder folder("made_calibration");
    const setup::Setup setup = test::swung_beam(folder, 0.1);
    Calibration made = test::made_calibration(setup);
    EXPECT_NEAR(made.deviation(0), 1300.0, 1e-9);
    EXPECT_EQ(made.deviation(1), 1e-4);
    made.numerical = {};
    EXPECT_EQ(made.deviation(0), 300.0);
    made.numerical.mesh = Eigen::Vector2d(400.0, 0.0);
    EXPECT_NEAR(made.deviation(0), 500.0, 1e-9);
    // A parameter that is fixed, or that the data do not determine, has no error of the mesh either.
    made.fit.deviations(0) = 0.0;
    EXPECT_EQ(made.deviation(0), 0.0);
    made.fit.deviations(0) = std::nan("");
    EXPECT_TRUE(std::isnan(made.deviation(0)));
    EXPECT_EQ(made.evaluations(), 2);
    EXPECT_EQ(made.undetermined_reason(0), "");
}

}  // namespace
}  // namespace myo::calibration
