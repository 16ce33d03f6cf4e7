#include "diagnosis/fit/fit_data.hpp"

#include <gtest/gtest.h>

#include "diagnosis/discretisation/numerical_error.hpp"
#include "diagnosis/made_problem.hpp"

// Flattened residuals and shifts of two trials of one marker.

namespace myo::diagnosis::fit_data_test {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Prediction whose residual along x has these values [m].
prediction::TrialPrediction prediction_of(const VectorXd& along_x) {
    prediction::TrialPrediction made;
    made.status = dynamics::RunStatus::complete;
    made.residual_m = test::made_shift({along_x})[0];
    made.positions_m = made.residual_m;
    return made;
}

const VectorXd first = VectorXd::LinSpaced(3, 1e-4, 3e-4), second = VectorXd::LinSpaced(3, 4e-4, 6e-4);

TEST(FitData, FlattensTrialsInTheirOrder) {
    FitData data = test::made_data(3, 2);
    const VectorXd flat = flat_residual(data, {prediction_of(first), prediction_of(second)});
    EXPECT_LT((flat - VectorXd::LinSpaced(6, 1.0, 6.0)).norm(), 1e-12);
    data.trials = {1, 0};  // predictions follow the order of the trials, entries that of the layout
    const VectorXd swapped = flat_residual(data, {prediction_of(second), prediction_of(first)});
    EXPECT_LT((swapped - flat).norm(), 1e-12);
}

TEST(FitData, AddsTheShiftToTheResidual) {
    FitData data = test::made_data(3, 2);
    const VectorXd before = flat_residual(data, {prediction_of(first), prediction_of(second)});
    data.shift = test::made_shift({VectorXd::Constant(3, 2e-4), VectorXd::Zero(3)});
    const VectorXd change = flat_residual(data, {prediction_of(first), prediction_of(second)}) - before;
    EXPECT_LT((change.head(3) - VectorXd::Constant(3, 2.0)).norm(), 1e-12);
    EXPECT_LT(change.tail(3).norm(), 1e-12);
    EXPECT_LT((flat_shift(data, data.shift) - change).norm(), 1e-12);
    data.shift[0].clear();  // a trial without a shift
    EXPECT_LT(flat_shift(data, data.shift).norm(), 1e-15);
    EXPECT_EQ(flat_shift(data, {}).size(), 6);
}

TEST(FitData, DividesTangentsByTheNoise) {
    FitData data = test::made_data(3, 2);
    data.noise_m.tail(3) *= 2.0;
    const VectorXd flat = flat_tangent(data, test::made_shift({first, second}));
    EXPECT_LT((flat.head(3) - first / test::made_noise_m).norm(), 1e-12);
    EXPECT_LT((flat.tail(3) - 0.5 * second / test::made_noise_m).norm(), 1e-12);
    std::vector<prediction::TrialPrediction> predictions{prediction_of(first), prediction_of(second)};
    for (prediction::TrialPrediction& p : predictions) p.tangents = {p.residual_m};
    EXPECT_LT((flat_jacobian(data, predictions, 1).col(0) - flat).norm(), 1e-12);
}

TEST(FitData, KnowsRootMeanSquares) {
    FitData data = test::made_data(2, 2);
    data.noise_m << 1e-4, 1e-4, 7e-4, 7e-4;
    EXPECT_NEAR(mean_noise_m(data), 5e-4, 1e-15);
    EXPECT_NEAR(flat_rms_m(data, Eigen::Vector4d(7.0, 7.0, 1.0, 1.0)), 7e-4, 1e-15);
    EXPECT_EQ(mean_noise_m({}), 0.0);
}

TEST(FitData, WorstTrialHasTheLargestMeanSquare) {
    const FitData data = test::made_data(2, 2);
    EXPECT_EQ(worst_trial(data, Eigen::Vector4d(1.0, 1.0, 0.0, 1.3)), 0u);
    EXPECT_EQ(worst_trial(data, Eigen::Vector4d(1.0, 1.0, 0.0, -1.5)), 1u);
}

TEST(FitData, ShiftsPredictionsOfTrialsThatHaveAShift) {
    const PredictionShift shift = test::made_shift({VectorXd::Constant(3, 2e-4)});
    const prediction::TrialPrediction moved = shifted(prediction_of(first), shift, 0);
    EXPECT_NEAR(moved.residual_m[0](0, 0), 3e-4, 1e-15);
    EXPECT_NEAR(moved.positions_m[0](0, 2), 5e-4, 1e-15);
    EXPECT_EQ(shifted(prediction_of(first), {}, 0).residual_m[0](0, 0), 1e-4);
    prediction::TrialPrediction failed = prediction_of(first);
    failed.status = dynamics::RunStatus::failed;
    EXPECT_EQ(shifted(failed, shift, 0).residual_m[0](0, 0), 1e-4);
}

TEST(Shift, DifferencesOfWhatIsNotSeenAreZero) {
    prediction::TrialPrediction fine = prediction_of(second), coarse = prediction_of(first);
    coarse.residual_m[0](0, 1) = std::nan("");
    const std::vector<Matrix3Xd> change = difference(fine, coarse);
    EXPECT_NEAR(change[0](0, 0), 3e-4, 1e-15);
    EXPECT_EQ(change[0](0, 1), 0.0);
}

TEST(Shift, SumsStartAtZero) {
    std::vector<Matrix3Xd> sum;
    const std::vector<Matrix3Xd> track = test::made_shift({first})[0];
    add_scaled(track, 2.0, sum);
    add_scaled(track, -0.5, sum);
    EXPECT_NEAR((sum[0] - 1.5 * track[0]).norm(), 0.0, 1e-15);
}

/// Only trials that have a shift count, each coordinate once.
TEST(Shift, RmsIsOverTheTrialsThatHaveOne) {
    PredictionShift shift = test::made_shift({VectorXd::Constant(4, 3e-4)});
    EXPECT_NEAR(shift_rms_m(shift), 3e-4 / std::sqrt(3.0), 1e-15);
    shift.emplace_back();
    EXPECT_NEAR(shift_rms_m(shift), 3e-4 / std::sqrt(3.0), 1e-15);
    EXPECT_EQ(shift_rms_m({}), 0.0);
}

}  // namespace
}  // namespace myo::diagnosis::fit_data_test
