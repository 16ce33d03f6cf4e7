#include <gtest/gtest.h>

#include "calibration/calibrate.hpp"
#include "prediction/prediction.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

// Ends of several starts are listed, also where a fit with shorter steps goes on from the best of them.

namespace myo::calibration::listed_starts_test {
namespace {

/// The beam let go for 0.2 s, to be fitted with steps of the whole sampling interval, twice as long as are ever chosen.
setup::Setup with_long_steps(const test::Folder& folder) {
    setup::Setup setup = test::swung_beam(folder, 0.2);
    prediction::ParameterValues values = prediction::declared_values(setup);
    values.youngs_modulus_Pa = 2.8e5;
    const prediction::TrialPrediction truth = prediction::predict_trial(setup, 0, values);
    for (std::size_t t = 0; t < setup.trials.size(); ++t) test::record(setup, t, values, truth.trace);
    for (setup::PreparedTrial& trial : setup.trials) set_step(trial, 0.01);
    return setup;
}

TEST(ListedStarts, StayWhenAFitWithShorterStepsFollows) {
    const test::Folder folder("listed_starts");
    setup::Setup setup = with_long_steps(folder);
    CalibrationSettings settings;
    settings.starts = 2;
    settings.seed = 4;
    const Calibration found = calibrate_with_chosen_steps(setup, settings);
    ASSERT_TRUE(found.fit.converged()) << found.fit.message;
    ASSERT_LT(setup.trials[0].options.h_s, 0.0075) << "the fit was not repeated";
    ASSERT_GE(found.starts.size(), 3u);
    EXPECT_EQ(found.settings.starts, 2);
    EXPECT_EQ(found.settings.seed, 4u);
    EXPECT_EQ(found.starts[0].start(0), 2.6e5);
    EXPECT_NE(found.starts[1].start(0), 2.6e5);
    // The last one begins where the better of the first two ended, and is the result.
    const CalibrationStart& better = found.starts[found.starts[0].cost_after <= found.starts[1].cost_after ? 0 : 1];
    EXPECT_DOUBLE_EQ(found.starts[2].start(0), better.values(0));
    EXPECT_EQ(found.starts.back().values(0), found.fit.values(0));
    std::size_t evaluations = 0;
    for (const CalibrationStart& start : found.starts) evaluations += start.history.size();
    EXPECT_EQ(static_cast<std::size_t>(found.evaluations()), evaluations);
    EXPECT_EQ(found.earlier_evaluations, 0);
}

}  // namespace
}  // namespace myo::calibration::listed_starts_test
