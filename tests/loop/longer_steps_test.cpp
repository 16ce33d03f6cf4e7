#include "loop/longer_steps.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "loop/diagnosis_work.hpp"
#include "loop/fit_declared.hpp"
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
    const LongerSteps longer = longer_steps(study, values, mean_noise(study), {});
    ASSERT_EQ(longer.factors.size(), 2u);
    EXPECT_EQ(longer.factors[0], 2.0 * longer.factors[1]);
    EXPECT_GT(longer.factors[1], 1.0);
    EXPECT_LT(longer.factors[1] * study.trials[1].options.h_s, 0.01);
    const auto change = [&](double factor) {
        Study changed = study;
        changed.trials[1].options.h_s *= factor;
        return rms_between(predict_trial(changed, 1, values), predict_trial(study, 1, values)) / mean_noise(study);
    };
    EXPECT_LE(change(longer.factors[1]), 1.0);
    EXPECT_GT(change(2.0 * longer.factors[1]), 1.0);
}

TEST(LongerSteps, AreNoLongerThanASamplingInterval) {
    const test::Folder folder("longest_steps");
    Study study = test::swung_beam(folder, 0.1);
    const LongerSteps longer = longer_steps(study, declared_values(study), 1.0, {});
    EXPECT_EQ(longer.factors, (std::vector<double>{2.0, 2.0})) << "of half an interval";
    EXPECT_EQ(longer.runs, 4);
    EXPECT_EQ(steps_in_words(study), "5 ms");
    EXPECT_EQ(steps_in_words(study, {1.0, 2.0}), "5 to 10 ms");
}

/// Cameras at rest are far better than a model that lacks something: steps are as long as that asks for.
TEST(LongerSteps, AreLongerWhereTheDeclaredFitLeavesMuch) {
    for (const double missing_kg_m3 : {0.0, 5000.0}) {
        const test::Folder folder("longer_for_left");
        Study study = test::swung_beam(folder, 0.3);
        study.noise_m.setConstant(1e-6);
        for (StudyTrial& trial : study.trials) trial.options.h_s = 0.0025;
        StudyValues truth = declared_values(study);
        if (missing_kg_m3 > 0.0) truth.effects.push_back({"quadratic_drag", {{"coefficient_kg_m3", missing_kg_m3}}});
        for (std::size_t t = 0; t < study.trials.size(); ++t)
            test::record(study, t, truth, predict_trial(study, t, truth).trace);
        const Progress progress;
        const std::function<void(const Diagnosis&)> nobody;
        DiagnoseSettings settings;
        settings.refine_mesh = false;
        DiagnosisWork work(study, settings, progress, nobody);
        ASSERT_TRUE(fit_declared(work)) << work.result.failure;
        EXPECT_EQ(work.study.trials[0].options.h_s > 0.0026, missing_kg_m3 > 0.0);
        EXPECT_EQ(as_diagnosed(work.result, study).trials[0].options.h_s, work.study.trials[0].options.h_s);
        if (missing_kg_m3 > 0.0) {
            EXPECT_GT(work.result.declared.rms_m, 1e-4);
            EXPECT_LT(work.result.numerics.step_rms_m, longer_steps_policy.share_of_left * work.result.declared.rms_m);
            EXPECT_NE(work.result.notes.front().find("5 ms, whose error is taken off"), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace myo
