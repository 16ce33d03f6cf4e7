#include "diagnosis/discretisation/longer_steps.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/discretisation/correct_discretisation.hpp"
#include "diagnosis/fit/declared_fit.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis {
namespace {

/// A trial whose steps are already long gets fewer doublings: each is as long as the noise allows.
TEST(LongerSteps, AreAsLongAsTheNoiseAllowsInEachTrial) {
    const test::Folder folder("longer_steps");
    setup::Setup setup = test::swung_beam(folder);
    setup.noise_m *= 0.2;
    setup.trials[0].options.h_s = 0.000625;
    setup.trials[1].options.h_s = 0.00125;
    const prediction::ParameterValues values = prediction::declared_values(setup);
    const LongerSteps longer = longer_steps(setup, values, setup::mean_noise(setup), {});
    ASSERT_EQ(longer.factors.size(), 2u);
    EXPECT_EQ(longer.factors[0], 2.0 * longer.factors[1]);
    EXPECT_GT(longer.factors[1], 1.0);
    EXPECT_LT(longer.factors[1] * setup.trials[1].options.h_s, 0.01);
    const auto change = [&](double factor) {
        setup::Setup changed = setup;
        changed.trials[1].options.h_s *= factor;
        return prediction::rms_between(prediction::predict_trial(changed, 1, values),
                                       prediction::predict_trial(setup, 1, values)) /
               setup::mean_noise(setup);
    };
    EXPECT_LE(change(longer.factors[1]), 1.0);
    EXPECT_GT(change(2.0 * longer.factors[1]), 1.0);
}

TEST(LongerSteps, AreNoLongerThanASamplingInterval) {
    const test::Folder folder("longest_steps");
    setup::Setup setup = test::swung_beam(folder, 0.1);
    const LongerSteps longer = longer_steps(setup, prediction::declared_values(setup), 1.0, {});
    EXPECT_EQ(longer.factors, (std::vector<double>{2.0, 2.0})) << "of half an interval";
    EXPECT_EQ(longer.runs, 4);
    EXPECT_EQ(steps_in_words(setup), "5 ms");
    EXPECT_EQ(steps_in_words(setup, {1.0, 2.0}), "5 to 10 ms");
}

/// Cameras at rest are far better than a model that lacks something: steps are as long as that asks for.
TEST(LongerSteps, AreLongerWhereTheDeclaredFitLeavesMuch) {
    for (const double missing_kg_m3 : {0.0, 5000.0}) {
        const test::Folder folder("longer_for_left");
        setup::Setup setup = test::swung_beam(folder, 0.3);
        setup.noise_m.setConstant(1e-6);
        for (setup::PreparedTrial& trial : setup.trials) trial.options.h_s = 0.0025;
        prediction::ParameterValues truth = prediction::declared_values(setup);
        if (missing_kg_m3 > 0.0) truth.effects.push_back({"quadratic_drag", {{"coefficient_kg_m3", missing_kg_m3}}});
        for (std::size_t t = 0; t < setup.trials.size(); ++t)
            test::record(setup, t, truth, prediction::predict_trial(setup, t, truth).trace);
        DiagnoseSettings settings;
        settings.refine_mesh = false;
        PhaseLog log{Progress()};
        FitStore store;
        const DeclaredFit declared = fit_declared(prepared_setup(setup, settings), settings, store, log);
        ASSERT_TRUE(declared.usable()) << declared.failure;
        EXPECT_EQ(declared.setup.trials[0].options.h_s > 0.0026, missing_kg_m3 > 0.0);
        Diagnosis diagnosis;
        diagnosis.step_factors = declared.step_factors;
        EXPECT_EQ(as_diagnosed(diagnosis, setup).trials[0].options.h_s, declared.setup.trials[0].options.h_s);
        if (missing_kg_m3 > 0.0) {
            const std::optional<CorrectedDeclaredFit> corrected = correct_declared_fit(
                {declared.setup, declared.data, settings, {}, "declared fit", settings.policy.declared.correction},
                declared.fit, store, log);
            ASSERT_TRUE(corrected);
            EXPECT_GT(corrected->fit.rms_m, 1e-4);
            EXPECT_LT(corrected->fit.numerics->step_rms_m, NumericsPolicy{}.step_change_of_left * corrected->fit.rms_m);
            EXPECT_NE(declared.notes.front().find("5 ms, whose error is taken off"), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace myo::diagnosis
