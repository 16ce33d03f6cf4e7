#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <vector>

#include "diagnosis/discretisation/effective_modulus.hpp"
#include "diagnosis/discretisation/longer_steps.hpp"
#include "diagnosis/discretisation/refinement.hpp"
#include "prediction/predict_trials.hpp"
#include "support/swung_beam.hpp"

// Numerical errors of a beam that swings for a tenth of a second: extrapolation, effective modulus, steps.

namespace myo::diagnosis::numerical_shift_test {
namespace {

using Eigen::Matrix3Xd;
using Tracks = std::vector<Matrix3Xd>;
using Predictions = std::vector<prediction::TrialPrediction>;

const NumericsPolicy policy;

class NumericalShift : public ::testing::Test {
protected:
    Predictions run(double step_factor, double modulus_factor) const {
        setup::Setup changed = setup_;
        changed.modulus_factor = modulus_factor;
        changed.trials[0].options.h_s *= step_factor;
        return prediction::predict_trials_with(changed, values_, {0});
    }
    static void expect_equal(const Tracks& found, const Tracks& expected, double factor) {
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t m = 0; m < found.size(); ++m)
            EXPECT_LT((found[m] - factor * expected[m]).norm(), 1e-9 * expected[m].norm()) << m;
    }

    test::Folder folder_{"numerical_shift"};
    setup::Setup setup_ = test::swung_beam(folder_, 0.1);
    prediction::ParameterValues values_ = prediction::declared_values(setup_);
    std::vector<std::size_t> first_{0};
};

/// Four thirds of the change by half the step; a known step error is used again if it is far below the noise.
TEST_F(NumericalShift, OfTheStepIsExtrapolated) {
    const Refinement none = refined(setup_, false, policy, {});
    EXPECT_EQ(none.finer, nullptr);
    const NumericalError error = error_at({setup_, none, values_, first_}, policy, {});
    const Tracks change = difference(run(0.5, 1.0)[0], run(1.0, 1.0)[0]);
    ASSERT_GT(shift_rms_m({change}), 0.0);
    expect_equal(error.shift[0], change, 4.0 / 3.0);
    EXPECT_NEAR(error.step_rms_m / shift_rms_m({change}), 1.0, 1e-9);
    EXPECT_TRUE(error.shift[1].empty() && error.mesh_change[0].empty());
    EXPECT_EQ(error.mesh_ratio, 0.0);
    EXPECT_EQ(error.message, "no finer mesh could be made");

    NumericalError known = error;
    for (Matrix3Xd& track : known.step_shift[0]) track *= 10.0;
    for (const bool reused : {true, false}) {
        known.step_rms_m = (reused ? 0.999 : 1.001) * policy.negligible_step_error * setup_.noise_m.minCoeff();
        const NumericalError again = error_at({setup_, none, values_, first_, &known}, policy, {});
        expect_equal(again.shift[0], change, (reused ? 10.0 : 1.0) * 4.0 / 3.0);
        EXPECT_EQ(again.step_rms_m == known.step_rms_m, reused);
    }
}

/// Errors that are made of the derivative by the modulus itself are all modulus, up to the second order.
TEST_F(NumericalShift, BecomesAModulus) {
    const double step = policy.modulus_step;
    Tracks column;
    add_scaled(difference(run(1.0, 1.0 - step)[0], run(1.0, 1.0)[0]), -1.0 / step, column);
    NumericalError error;
    error.step_ratio = 0.5;
    error.shift = error.step_shift = error.mesh_change = PredictionShift(2);
    const auto made_of = [&](double by_mesh, double by_step, double by_finer_mesh) {
        error.shift[0] = error.step_shift[0] = error.mesh_change[0] = {};
        add_scaled(column, by_mesh + by_step, error.shift[0]);
        add_scaled(column, by_step, error.step_shift[0]);
        add_scaled(column, by_finer_mesh, error.mesh_change[0]);
    };
    made_of(0.02, 0.01, 0.015);
    FitData data = fit_data(setup_, first_);
    const double rms_m = flat_rms_m(data, flat_shift(data, error.shift));
    data.noise_m.setConstant(rms_m / (1.001 * policy.min_error_for_modulus));
    const std::optional<NumericalError> found = match_modulus(setup_, values_, data, error, policy, {});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->effective_modulus.mesh, 0.02, 1e-9);
    EXPECT_NEAR(found->effective_modulus.step, 0.01, 1e-9);
    EXPECT_NEAR(found->effective_modulus.finer_mesh, 0.02 - 0.015, 1e-9);
    EXPECT_NEAR(found->effective_modulus.finer_step, 0.25 * 0.01, 1e-9) << "half the step has a quarter of the error";
    expect_equal(found->by_modulus[0], column, 0.03);
    EXPECT_LT(shift_rms_m(found->step_shift), 1e-9 * rms_m);
    EXPECT_LT(found->rest_rms_m, 0.2 * rms_m);
    data.noise_m.setConstant(rms_m / (0.999 * policy.min_error_for_modulus));
    EXPECT_FALSE(match_modulus(setup_, values_, data, error, policy, {})) << "far below the noise";
    made_of(-1.0, 0.0, 0.0);
    EXPECT_EQ(match_modulus(setup_, values_, data, error, policy, {})->effective_modulus.mesh,
              -policy.max_modulus_change);
}

TEST_F(NumericalShift, KeepsStepsThatNothingAllowsToGrow) {
    const LongerSteps kept = longer_steps(setup_, values_, 0.0, {});
    EXPECT_EQ(kept.factors, (std::vector<double>{1.0, 1.0}));
    EXPECT_FALSE(any_longer(kept.factors));
    EXPECT_EQ(kept.runs, 4) << "as they are, and once doubled";
    setup_.trials[1].options.h_s = 0.006;
    EXPECT_EQ(longer_steps(setup_, values_, 0.0, {}).runs, 3) << "12 ms exceed the sampling interval";
    setup_.trials[1].hold = true;
    const LongerSteps held = longer_steps(setup_, values_, 1.0, {});
    EXPECT_EQ(held.factors, (std::vector<double>{2.0, 1.0})) << "a pose has no steps";
    EXPECT_EQ(held.runs, 2);
    EXPECT_TRUE(any_longer(held.factors));
    std::atomic<bool> cancel = true;
    EXPECT_FALSE(any_longer(longer_steps(setup_, values_, 1.0, Progress({}, &cancel)).factors));
}

}  // namespace
}  // namespace myo::diagnosis::numerical_shift_test
