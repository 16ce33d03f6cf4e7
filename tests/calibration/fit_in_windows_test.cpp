#include "calibration/fit_in_windows.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::calibration {
namespace {

constexpr double true_modulus_Pa = 3.2e5;  // within the declared 2.6e5 +- 30 %

/// The beam let go under gravity for 9 periods of little damping, with this modulus.
setup::Setup long_swing(const test::Folder& folder) {
    setup::Setup setup = test::swung_beam(folder, 1.2);
    setup.experiment.material.damping_s = 2e-4;
    for (setup::PreparedTrial& trial : setup.trials) {
        trial.model.damping_s = 2e-4;
        set_step(trial, 0.0025);
    }
    prediction::ParameterValues values = prediction::declared_values(setup);
    values.youngs_modulus_Pa = true_modulus_Pa;
    const prediction::TrialPrediction truth = prediction::predict_trial(setup, 0, values);
    test::record(setup, 0, values, truth.trace);
    return setup;
}

TEST(FitInWindows, FindsTheModulusThatAFitOfTheWholeTrialMisses) {
    const test::Folder folder("fit_in_windows");
    setup::Setup setup = long_swing(folder);
    const Calibration whole = calibrate(setup);
    ASSERT_TRUE(whole.usable());
    // It has taken one period for another: otherwise there is nothing to show here.
    ASSERT_GT(std::abs(whole.fit.values(0) / true_modulus_Pa - 1.0), 0.03);
    setup.settings.h_s = 0.0025;
    const Calibration found = calibrate_with_chosen_steps(setup);
    EXPECT_NEAR(found.fit.values(0) / true_modulus_Pa, 1.0, 1e-3);
    EXPECT_GT(found.earlier_evaluations, 0);
}

TEST(FitInWindows, LooksForNothingWhereTheFitLeavesTheNoise) {
    const test::Folder folder("fit_explained");
    const setup::Setup setup = long_swing(folder);
    CalibrationSettings near;
    near.from["youngs_modulus_Pa"] = 1.01 * true_modulus_Pa;
    const Calibration right = calibrate(setup, near);
    ASSERT_LT(right.after.fit_rms_m, 1.2e-4);
    EXPECT_TRUE(start_from_windows(setup, right).empty());
}

/// The bounds leave nothing open of less than a period.
TEST(FitInWindows, LooksForNothingWhereNoPeriodCanBeMistaken) {
    const test::Folder folder("fit_short");
    setup::Setup setup = test::swung_beam(folder, 0.1);
    prediction::ParameterValues values = prediction::declared_values(setup);
    const prediction::TrialPrediction truth = prediction::predict_trial(setup, 0, values);
    test::record(setup, 0, values, truth.trace);
    for (Eigen::Matrix3Xd& track : setup.trials[0].measured.tracks) track.row(1).array() += 1e-3;  // unexplained
    const Calibration fit = calibrate(setup);
    ASSERT_GT(fit.after.fit_rms_m, 3e-4);
    EXPECT_TRUE(start_from_windows(setup, fit).empty());
}

}  // namespace
}  // namespace myo::calibration
