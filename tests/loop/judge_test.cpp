#include "loop/judge.hpp"

#include <gtest/gtest.h>

namespace myo {
namespace {

JudgedFit fit(double held_out, double held_out_in_time, int told_by_one) {
    JudgedFit fit;
    fit.fit.residual = Eigen::VectorXd::LinSpaced(400, -1.0, 1.0);
    fit.held_out_rms = held_out;
    fit.held_out_in_time_rms = held_out_in_time;
    fit.told_by_one = told_by_one;
    return fit;
}

/// A number that one trial alone tells of is as it was fitted when that is held out: it wins there without being tested.
TEST(Weigh, ComparesByTimeWhatHoldingOutATrialDoesNotTest) {
    FitData data;
    data.layout.series = {{0, 0, 0, 0, 400}};
    for (int k = 0; k < 400; ++k) {
        data.layout.sample.push_back(k);
        data.layout.time_s.push_back(0.01 * k);
    }
    for (const double in_time : {0.8, 1.6}) {
        JudgedFit of_one_trial = fit(0.9, in_time, 2), of_all = fit(1.2, 1.2, 1), broken = fit(0.1, 0.1, 0);
        broken.fit.residual.resize(0);
        weigh(data, {&of_one_trial, &of_all, &broken});
        EXPECT_EQ(of_one_trial.criterion < of_all.criterion, in_time < 1.0);
        EXPECT_EQ(broken.weight, 0.0);
    }
    JudgedFit worse = fit(1.4, 0.5, 2), better = fit(1.2, 1.2, 1);   // not even flattered it is best: nothing to be asked again
    weigh(data, {&worse, &better});
    EXPECT_LT(better.criterion, worse.criterion);
}

}  // namespace
}  // namespace myo
