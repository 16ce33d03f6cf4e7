#include "inverse/actuation_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>

#include "inverse/actuated_beam.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"

namespace myo::inverse {
namespace {

using Eigen::MatrixXd;
using test::actuated_beam;
using test::aim_at;
using test::wave;

struct Case {
    bool hold, from_before, from_start;
    bool seek_before = false;
};

class ActuationFits : public testing::TestWithParam<Case> {
protected:
    ActuationProblem problem() const {
        ActuationProblem problem = actuated_beam(GetParam().hold, GetParam().from_before, GetParam().from_start);
        problem.sought.seek_before = GetParam().seek_before;
        return problem;
    }
};

TEST_P(ActuationFits, GradientOfTheLossEqualsDifferences) {
    ActuationProblem p = problem();
    aim_at(p, wave(p.sought));
    p.smoothness_m_s = 1e-4;
    p.options.solver.tolerance = 1e-11;
    const MatrixXd at = unmoved_values(p.sought) + 0.3 * (wave(p.sought) - unmoved_values(p.sought));
    const auto loss = [&](const Eigen::VectorXd& x) {
        const MatrixXd values = x.reshaped(at.rows(), at.cols());
        return Eigen::VectorXd::Constant(1, evaluate_actuation(p, values).loss_m2);
    };
    const ActuationEvaluation evaluation = evaluate_actuation(p, at);
    ASSERT_TRUE(evaluation.ok()) << evaluation.message;
    test::expect_derivative(evaluation.gradient.reshaped().transpose(),
                            test::central_differences(loss, at.reshaped(), 1e-3), 1e-4, "loss");
}

TEST_P(ActuationFits, RecoversTheSignalsThatMadeTheTarget) {
    ActuationProblem p = problem();
    const MatrixXd truth = wave(p.sought);
    aim_at(p, truth);
    ActuationFitOptions options;
    options.max_evaluations = 200;
    options.relative_decrease = 1e-7;
    const ActuationFit fit = fit_actuation(p, unmoved_values(p.sought), options);
    ASSERT_TRUE(fit.converged()) << fit.message;
    const double error = (fit.values - truth).cwiseAbs().maxCoeff();
    test::record("error_of_the_signal", error);
    test::record("evaluations", static_cast<double>(fit.log.size()));
    test::record("rms_before_mm", 1e3 * fit.first.rms_m);
    test::record("rms_after_mm", 1e3 * fit.best.rms_m);
    EXPECT_LT(error, 1e-5 * 0.08);  // of the amplitude
    EXPECT_LT(fit.best.rms_m, 1e-5 * fit.first.rms_m);
    EXPECT_EQ(evaluate_actuation(p, fit.values).loss_m2, fit.best.loss_m2);
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
    return std::string(info.param.hold ? "held" : "linear") + (info.param.from_before ? "_equilibrium" : "_straight") +
           (info.param.seek_before ? "_unknown_level" : "") + (info.param.from_start ? "_displacement" : "_position");
}

INSTANTIATE_TEST_SUITE_P(All, ActuationFits,
                         testing::Values(Case{false, false, false}, Case{true, false, true}, Case{false, true, true},
                                         Case{true, true, false}, Case{false, true, false, true},
                                         Case{true, true, false, true}),
                         case_name);

TEST(ActuationFit, StaysWithinBoundsAndEndsOnThem) {
    ActuationProblem p = actuated_beam(false, true, true);
    aim_at(p, wave(p.sought));
    p.sought.signals[0].lower = 0.95;
    p.sought.signals[0].upper = 1.03;
    const ActuationFit fit = fit_actuation(p, unmoved_values(p.sought));
    ASSERT_TRUE(fit.converged()) << fit.message;
    EXPECT_GE(fit.values.minCoeff(), 0.95);
    EXPECT_LE(fit.values.maxCoeff(), 1.03);
    EXPECT_EQ(fit.values.minCoeff(), 0.95);
    EXPECT_EQ(fit.values.maxCoeff(), 1.03);
    EXPECT_LT(fit.best.loss_m2, 0.5 * fit.first.loss_m2);
}

TEST(ActuationFit, MoreSmoothnessMovesLessAndFollowsLess) {
    ActuationProblem p = actuated_beam(true, true, true);
    aim_at(p, wave(p.sought));
    double last_rate = 1e9, last_rms = 0.0;
    for (const double smoothness : {1e-5, 3e-4, 3e-3}) {
        p.smoothness_m_s = smoothness;
        const ActuationFit fit = fit_actuation(p, unmoved_values(p.sought));
        ASSERT_TRUE(fit.usable()) << fit.message;
        MatrixXd ignored = MatrixXd::Zero(fit.values.rows(), fit.values.cols());
        const double rate = mean_square_rate(p.sought, fit.values, 0.0, ignored);
        EXPECT_LT(rate, last_rate);
        EXPECT_GT(fit.best.rms_m, last_rms);
        last_rate = rate;
        last_rms = fit.best.rms_m;
    }
}

/// The cameras' frame is a little off; it is found with the signal, and the gradient is that of the loss with the frame
/// found anew each time.
TEST(ActuationFit, SeeksHowTheCamerasStandToo) {
    ActuationProblem p = actuated_beam(false, false, false);
    const MatrixXd truth = wave(p.sought);
    p.target.markers = measurement::marker_set(p.model.body->mesh,
                                               {{0.1, 0.015, 0.03}, {0.06, -0.006, 0.012}, {0.08, 0.03, 0.01}});
    p.target.placement = {{4e-4, -3e-4, 2e-4}, {2e-3, -1e-3, 3e-3}, 0.0};
    const MarkerPlacement placed = p.target.placement;
    aim_at(p, truth);
    p.target.placement = {};
    p.placement_bounds = PlacementBounds{1e-3, 1e-2};
    p.options.solver.tolerance = 1e-11;
    const MatrixXd at = unmoved_values(p.sought) + 0.3 * (truth - unmoved_values(p.sought));
    const auto loss = [&](const Eigen::VectorXd& x) {
        return Eigen::VectorXd::Constant(1, evaluate_actuation(p, x.reshaped(at.rows(), at.cols())).loss_m2);
    };
    test::expect_derivative(evaluate_actuation(p, at).gradient.reshaped().transpose(),
                            test::central_differences(loss, at.reshaped(), 1e-3), 1e-4, "loss");

    const ActuationFit fit = fit_actuation(p, unmoved_values(p.sought), {300, 1e-9});
    ASSERT_TRUE(fit.converged()) << fit.message;
    EXPECT_LT((fit.values - truth).cwiseAbs().maxCoeff(), 1e-3 * 0.08);
    EXPECT_LT((fit.best.placement.translation_m - placed.translation_m).norm(), 2e-6);
    EXPECT_LT((fit.best.placement.rotation_rad - placed.rotation_rad).norm(), 2e-5);
    EXPECT_FALSE(at_bound(fit.best.placement, *p.placement_bounds));
    p.placement_bounds = PlacementBounds{3e-4, 1e-2};
    EXPECT_TRUE(at_bound(evaluate_actuation(p, truth).placement, *p.placement_bounds));
}

TEST(ActuationFit, CancelledKeepsTheBestSoFar) {
    ActuationProblem p = actuated_beam(false, false, false);
    aim_at(p, wave(p.sought));
    std::atomic<bool> cancel = false;
    double last = 0.0;
    const Progress progress(
        [&](const ProgressEvent& event) {
            EXPECT_EQ(event.unit, "evaluations");
            EXPECT_GE(event.done, last);
            last = event.done;
            if (event.done >= 5.0) cancel = true;
        },
        &cancel);
    const ActuationFit fit = fit_actuation(p, unmoved_values(p.sought), {}, progress);
    EXPECT_EQ(fit.status, FitStatus::cancelled);
    ASSERT_TRUE(fit.usable());
    EXPECT_EQ(fit.log.size(), 5u);
    EXPECT_LT(fit.best.loss_m2, fit.first.loss_m2);
    double least = fit.first.loss_m2;
    for (const ActuationIterate& line : fit.log) least = std::min(least, line.loss_m2);
    EXPECT_EQ(fit.best.loss_m2, least);
    EXPECT_EQ(evaluate_actuation(p, fit.values).loss_m2, least);

    last = 0.0;
    const ActuationFit none = fit_actuation(p, unmoved_values(p.sought), {}, progress);
    EXPECT_EQ(none.status, FitStatus::cancelled);
    EXPECT_FALSE(none.usable());
}

TEST(ActuationSignals, HeldAndLinearSignalsPassTheirValuesOn) {
    SoughtSignals sought;
    sought.signals = {{"a", 0.5, 2.0, 1.0}};
    sought.groups = {{0, 1.0}, {0, -0.5}};
    sought.end_s = 0.2;
    sought.hold = true;
    sought.from_before = true;
    EXPECT_EQ(knot_times(sought).size(), 4u);
    MatrixXd values(1, 4);
    values << 1.1, 1.2, 1.3, 1.4;
    std::vector<fibre::Signal> held = commands_of(sought, values);
    EXPECT_EQ(held[0].value_before(0.0), 1.0);
    EXPECT_EQ(held[0].value(0.0), 1.1);
    EXPECT_EQ(held[0].value(0.12), 1.3);
    EXPECT_NEAR(held[1].value(0.12), 1.0 - 0.5 * 0.3, 1e-15);
    sought.hold = false;
    EXPECT_EQ(knot_times(sought).size(), 4u);  // that at 0 is not free
    const std::vector<fibre::Signal> linear = commands_of(sought, values);
    EXPECT_EQ(linear[0].value(0.0), 1.0);
    EXPECT_NEAR(linear[0].value(0.025), 1.05, 1e-15);
    EXPECT_EQ(linear[0].value(0.2), 1.4);
    sought.from_before = false;
    EXPECT_EQ(knot_times(sought).size(), 5u);
    EXPECT_EQ(knot_times(sought).front(), 0.0);
}

TEST(ActuationSignals, AnUnknownLevelBeforeTheStartIsTheFirstValue) {
    SoughtSignals sought;
    sought.signals = {{"a", 0.5, 2.0, 1.0}};
    sought.groups = {{0, 1.0}};
    sought.end_s = 0.2;
    sought.from_before = sought.seek_before = true;
    ASSERT_EQ(knot_times(sought).size(), 5u);
    EXPECT_EQ(knot_times(sought).front(), 0.0);
    MatrixXd values(1, 5);
    values << 0.9, 1.1, 1.2, 1.3, 1.4;
    const fibre::Signal linear = commands_of(sought, values).front();
    EXPECT_EQ(linear.value_before(0.0), 0.9);
    EXPECT_NEAR(linear.value(0.025), 1.0, 1e-15);
    sought.hold = true;  // what is held from t = 0 on is one more
    ASSERT_EQ(knot_times(sought).size(), 5u);
    EXPECT_LT(knot_times(sought).front(), 0.0);
    const fibre::Signal held = commands_of(sought, values).front();
    EXPECT_EQ(held.value_before(0.0), 0.9);
    EXPECT_EQ(held.value(0.0), 1.1);
    // Its jump at t = 0 is a change like the others.
    MatrixXd gradient = MatrixXd::Zero(1, 5);
    EXPECT_NEAR(mean_square_rate(sought, values, 1.0, gradient), 400.0 * (0.04 + 3 * 0.01) / 4.0, 1e-9);
    EXPECT_NEAR(gradient(0, 0), -400.0 * 2.0 * 0.2 / 4.0, 1e-9);
}

TEST(ActuationFit, EndsAtOnceWhereItsStartIsTheTarget) {
    ActuationProblem p = actuated_beam(false, true, false);
    aim_at(p, unmoved_values(p.sought));
    ActuationFitOptions options;
    options.met_rms_m = 1e-6;
    const ActuationFit fit = fit_actuation(p, unmoved_values(p.sought), options);
    EXPECT_TRUE(fit.converged());
    EXPECT_EQ(fit.log.size(), 1u);
    EXPECT_NE(fit.message.find("met from the start"), std::string::npos);
    p.target.positions_m.front().array() += 1e-5;
    EXPECT_GT(fit_actuation(p, unmoved_values(p.sought), options).log.size(), 1u);
}

}  // namespace
}  // namespace myo::inverse
