#include "project/fit_in_windows.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "loop/swung_beam.hpp"

namespace myo {
namespace {

constexpr double true_modulus_Pa = 3.2e5;   // within the declared 2.6e5 +- 30 %

/// The beam let go under gravity for 9 periods of little damping, with this modulus.
Study long_swing(const test::Folder& folder) {
    Study study = test::swung_beam(folder, 1.2);
    study.experiment.material.damping_s = 2e-4;
    for (StudyTrial& trial : study.trials) {
        trial.model.damping_s = 2e-4;
        set_step(trial, 0.0025);
    }
    StudyValues values = declared_values(study);
    values.youngs_modulus_Pa = true_modulus_Pa;
    const TrialPrediction truth = predict_trial(study, 0, values);
    test::record(study, 0, values, truth.trace);
    return study;
}

TEST(FitInWindows, FindsTheModulusThatAFitOfTheWholeTrialMisses) {
    const test::Folder folder("fit_in_windows");
    Study study = long_swing(folder);
    const Calibration whole = calibrate_study(study);
    ASSERT_TRUE(whole.usable());
    // It has taken one period for another: otherwise there is nothing to show here.
    ASSERT_GT(std::abs(whole.fit.values(0) / true_modulus_Pa - 1.0), 0.03);
    study.settings.h_s = 0.0025;
    const Calibration found = calibrate_with_chosen_steps(study);
    EXPECT_NEAR(found.fit.values(0) / true_modulus_Pa, 1.0, 1e-3);
    EXPECT_GT(found.earlier_evaluations, 0);
}

TEST(FitInWindows, LooksForNothingWhereTheFitLeavesTheNoise) {
    const test::Folder folder("fit_explained");
    const Study study = long_swing(folder);
    CalibrationSettings near;
    near.from["youngs_modulus_Pa"] = 1.01 * true_modulus_Pa;
    const Calibration right = calibrate_study(study, near);
    ASSERT_LT(right.after.fit_rms_m, 1.2e-4);
    EXPECT_TRUE(start_from_windows(study, right).empty());
}

/// The bounds leave nothing open of less than a period.
TEST(FitInWindows, LooksForNothingWhereNoPeriodCanBeMistaken) {
    const test::Folder folder("fit_short");
    Study study = test::swung_beam(folder, 0.1);
    StudyValues values = declared_values(study);
    const TrialPrediction truth = predict_trial(study, 0, values);
    test::record(study, 0, values, truth.trace);
    for (Eigen::Matrix3Xd& track : study.trials[0].measured.tracks) track.row(1).array() += 1e-3;   // unexplained
    const Calibration fit = calibrate_study(study);
    ASSERT_GT(fit.after.fit_rms_m, 3e-4);
    EXPECT_TRUE(start_from_windows(study, fit).empty());
}

}  // namespace
}  // namespace myo
