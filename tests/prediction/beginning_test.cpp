#include "setup/beginning.hpp"

#include <gtest/gtest.h>

#include "prediction/predict_trials.hpp"
#include "support/swung_beam.hpp"

namespace myo::prediction::beginning_test {
namespace {

/// The run of the beginning is the beginning of the run.
TEST(KeepBeginning, MovesAsTheWholeTrial) {
    const test::Folder folder("beginning");
    const setup::Setup whole = test::swung_beam(folder);
    setup::Setup part = whole;
    setup::keep_beginning(part.trials.front(), 7);
    EXPECT_EQ(part.trials.front().measured.sample_count(), 7);
    EXPECT_EQ(part.trials.front().measured.tracks.front().cols(), 7);
    EXPECT_LT(part.trials.front().options.end_s, whole.trials.front().options.end_s);
    const prediction::ParameterValues values = prediction::declared_values(whole);
    const prediction::TrialPrediction all = prediction::predict_trial(whole, 0, values),
                                      first = prediction::predict_trial(part, 0, values);
    ASSERT_TRUE(all.ok() && first.ok()) << all.message << first.message;
    ASSERT_EQ(first.residual_m.front().cols(), 7);
    EXPECT_LT((first.residual_m.front() - all.residual_m.front().leftCols(7)).norm(), 1e-9);
}

TEST(KeepBeginning, LeavesAShorterTrialAsItIs) {
    const test::Folder folder("beginning_short");
    setup::Setup setup = test::swung_beam(folder);
    const Eigen::Index samples = setup.trials.front().measured.sample_count();
    const double end_s = setup.trials.front().options.end_s;
    setup::keep_beginning(setup.trials.front(), samples + 5);
    EXPECT_EQ(setup.trials.front().measured.sample_count(), samples);
    EXPECT_EQ(setup.trials.front().options.end_s, end_s);
}

}  // namespace
}  // namespace myo::prediction::beginning_test
