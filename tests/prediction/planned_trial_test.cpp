#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "prediction/prediction.hpp"
#include "prediction/run_trials.hpp"
#include "prediction/untested_fit.hpp"
#include "support/chambered_beam.hpp"

// A trial without a recording moves as a recorded one does, and nothing can be fitted to it.

namespace myo::prediction {
namespace {

/// What was recorded has no influence on a run: without a recording the markers move the same way.
TEST(PlannedRun, MovesAsTheRecordedTrial) {
    const auto beam = [](const test::Folder& folder, experiment::TrialRole role) {
        return test::chambered_beam(folder, 0.2, [&](experiment::Experiment& e) {
            e.trials.resize(1);  // the others would have nothing to be fitted to
            e.trials[0].role = role;
            if (role == experiment::TrialRole::simulate) e.trials[0].trace.clear(), e.trials[0].duration_s = 0.2;
        });
    };
    const test::Folder with("planned_with"), without("planned_without");
    setup::Setup recorded = beam(with, experiment::TrialRole::fit),
                 planned = beam(without, experiment::TrialRole::simulate);
    setup::set_step(recorded.trials[0], 0.005);
    setup::set_step(planned.trials[0], 0.005);
    const TrialPrediction a = predict_trial(recorded, 0, declared_values(recorded)),
                          b = predict_trial(planned, 0, declared_values(planned));
    ASSERT_TRUE(a.ok()) << a.message;
    ASSERT_TRUE(b.ok()) << b.message;
    EXPECT_GT((a.trace.positions[20] - a.trace.positions[0]).norm(), 1e-3) << "it moves";
    EXPECT_LT((a.trace.positions[20] - b.trace.positions[20]).norm(), 1e-12);
    EXPECT_TRUE(std::isnan(score(planned, 0, b).rms_m));
    EXPECT_TRUE(require_fit_trial(recorded));
    const Result<void> nothing = require_fit_trial(planned);
    ASSERT_FALSE(nothing);
    EXPECT_THAT(nothing.error().what, testing::HasSubstr("none has a recording to fit"));
}

}  // namespace
}  // namespace myo::prediction
