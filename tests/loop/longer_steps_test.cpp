#include "loop/longer_steps.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "loop/swung_beam.hpp"

namespace myo {
namespace {

/// A trial whose steps are already long gets fewer doublings: each is as long as the noise allows.
TEST(LongerSteps, AreAsLongAsTheNoiseAllowsInEachTrial) {
    const test::Folder folder("longer_steps");
    Study study = test::swung_beam(folder);
    study.noise_m *= 0.2;
    study.trials[0].options.h_s = 0.000625;
    study.trials[1].options.h_s = 0.00125;
    const StudyValues values = declared_values(study);
    const LongerSteps longer = longer_steps(study, values, {});
    ASSERT_EQ(longer.factors.size(), 2u);
    EXPECT_EQ(longer.factors[0], 2.0 * longer.factors[1]);
    EXPECT_GT(longer.factors[1], 1.0);
    EXPECT_LT(longer.factors[1] * study.trials[1].options.h_s, 0.01);
    const auto change = [&](double factor) {
        Study changed = study;
        changed.trials[1].options.h_s *= factor;
        return rms_between(predict_trial(changed, 1, values), predict_trial(study, 1, values)) / mean_noise(study);
    };
    EXPECT_LE(change(longer.factors[1]), longer_steps_policy.most_change);
    EXPECT_GT(change(2.0 * longer.factors[1]), longer_steps_policy.most_change);
}

TEST(LongerSteps, AreNoLongerThanASamplingInterval) {
    const test::Folder folder("longest_steps");
    Study study = test::swung_beam(folder, 0.1);
    study.noise_m *= 1e6;
    const LongerSteps longer = longer_steps(study, declared_values(study), {});
    EXPECT_EQ(longer.factors, (std::vector<double>{2.0, 2.0})) << "of half an interval";
    EXPECT_EQ(longer.runs, 4);
    EXPECT_EQ(steps_in_words(study), "5 ms");
    EXPECT_EQ(steps_in_words(study, {1.0, 2.0}), "5 to 10 ms");
}

}  // namespace
}  // namespace myo
