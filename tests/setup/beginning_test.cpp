#include "setup/beginning.hpp"

#include <gtest/gtest.h>

// Beginning of a recording, to which a search may be limited: samples that stay, and end of the run.

namespace myo::setup::beginning_test {
namespace {

/// Samples every 20 ms from two before the start on; the run ends after `end_s`.
PreparedTrial recorded(int samples, double end_s) {
    PreparedTrial trial;
    trial.measured.rate_Hz = 50.0;
    trial.measured.time_s = Eigen::VectorXd::LinSpaced(samples, -0.04, -0.04 + 0.02 * (samples - 1));
    trial.measured.tracks.assign(2, trial.measured.time_s.transpose().replicate(3, 1));
    trial.measured.residual_m = {trial.measured.time_s};
    trial.options.end_s = end_s;
    return trial;
}

TEST(Beginning, EndsOneIntervalAfterItsLastSample) {
    PreparedTrial trial = recorded(10, 1.0);
    keep_beginning(trial, 6);
    EXPECT_EQ(trial.measured.sample_count(), 6);
    EXPECT_NEAR(trial.options.end_s, 0.06 + 0.02, 1e-12);
    for (const Eigen::Matrix3Xd& track : trial.measured.tracks) {
        ASSERT_EQ(track.cols(), 6);
        EXPECT_NEAR(track(2, 5), 0.06, 1e-12) << "the first samples, not the last";
    }
    EXPECT_EQ(trial.measured.residual_m[0].size(), 6);
    keep_beginning(trial, 6);
    EXPECT_NEAR(trial.options.end_s, 0.08, 1e-12);
}

TEST(Beginning, LengthensNoRun) {
    PreparedTrial ended = recorded(10, 0.05), whole = recorded(10, 1.0);
    keep_beginning(ended, 6);
    EXPECT_EQ(ended.options.end_s, 0.05);
    keep_beginning(whole, 10);
    EXPECT_EQ(whole.options.end_s, 1.0) << "nothing is cut";
    whole.measured.residual_m.clear();  // a file without residuals
    whole.measured.rate_Hz = 0.0;
    keep_beginning(whole, 9);
    EXPECT_NEAR(whole.options.end_s, 0.12 + 0.01, 1e-12) << "an interval of 10 ms where none is known";
}

}  // namespace
}  // namespace myo::setup::beginning_test
