#include "diagnosis/screening/probe_score.hpp"

#include <gtest/gtest.h>

#include "diagnosis/made_problem.hpp"
#include "effect/catalogue.hpp"

// Scores of probes against the least-squares solutions of problems of a few numbers.

namespace myo::diagnosis::probe_score_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int samples = 8;
constexpr const char* amount = "coefficient_kg_m3";

const effect::Effect& drag() { return *effect::find_effect("quadratic_drag"); }
effect::EffectProbe drag_probe() { return effect::probe({{amount, 50.0}}, amount); }

VectorXd unit(int k) { return VectorXd::Unit(samples, k); }

EffectScore score(const JointFit& fit, const MatrixXd& S, const ScreeningPolicy& policy = ScreeningPolicy{}) {
    const FitData data = test::made_data(samples);
    return score_probe(drag(), drag_probe(), S, score_reference(fit, data.layout), policy);
}

/// Residual -(3, 4) along two directions; the modulus acts along a third one.
JointFit residual_of_two() { return test::made_fit(-3.0 * unit(0) - 4.0 * unit(1), unit(7)); }

TEST(ProbeScore, ExplainsTheShareAlongItsResponse) {
    const EffectScore found = score(residual_of_two(), unit(0));
    ASSERT_TRUE(found.usable());
    EXPECT_EQ(found.id, "quadratic_drag");
    EXPECT_NEAR(found.share(), 9.0 / 25.0, 1e-12);
    EXPECT_NEAR(found.left, 16.0, 1e-9);
    EXPECT_NEAR(effect::number(found.best.effect, amount), 3.0 * 50.0, 1e-6);
    EXPECT_NEAR(effect::number(found.probed, amount), 50.0, 0.0);
    EXPECT_NEAR((found.predicted + 3.0 * unit(0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(found.candidate.kept(0), 1.0, 1e-12);
}

TEST(ProbeScore, CountsOnlyWhatTheModulusDoesNotAbsorb) {
    const JointFit fit = test::made_fit(-unit(0) - unit(1), unit(1));
    const ScoreReference reference = score_reference(fit, test::made_data(samples).layout);
    EXPECT_NEAR(reference.squares, 1.0, 1e-9) << "the modulus takes one of the two directions";
    EXPECT_NEAR((reference.outside + unit(0)).norm(), 0.0, 1e-12);
    const EffectScore found = score(fit, unit(0) + unit(1));
    EXPECT_NEAR(found.candidate.kept(0), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(found.share(), 1.0, 1e-6);
    EXPECT_FALSE(score(fit, unit(1)).usable()) << "the modulus does all that";
    EXPECT_FALSE(score(fit, VectorXd::Zero(samples)).usable());
}

/// Modulus and effect act along one direction each; the modulus would have to fall below its bound.
TEST(ProbeScore, TheModulusStaysWithinItsBounds) {
    const JointFit fit = test::made_fit(unit(0) + 2.0 * unit(1), unit(1));
    const ScoreReference reference = score_reference(fit, test::made_data(samples).layout);
    EXPECT_NEAR(reference.lower(0), -0.5 * test::made_modulus_Pa, 1e-9);
    EXPECT_NEAR(reference.upper(0), test::made_modulus_Pa, 1e-9);
    EXPECT_NEAR(reference.squares, 1.0 + 1.5 * 1.5, 1e-9);
    const EffectScore found = score(fit, -unit(0));
    EXPECT_NEAR(found.left, 1.5 * 1.5, 1e-9);
    EXPECT_NEAR(found.best.step(0), -0.5 * test::made_modulus_Pa, 1e-6);
}

TEST(ProbeScore, OfTheWrongSignExplainsNothing) {
    const EffectScore found = score(residual_of_two(), -unit(0));  // a drag is not negative
    EXPECT_EQ(found.share(), -1.0);
    EXPECT_NEAR(found.left, 25.0, 1e-9);
}

/// An amount is at most so large that its response outside the modulus is twice the residual.
TEST(ProbeScore, LimitsTheAmountByTheResponse) {
    const JointFit fit = test::made_fit(-10.0 * unit(0), unit(7));
    ScreeningPolicy policy;
    policy.max_outside = 0.5;
    EXPECT_NEAR(effect::number(score(fit, unit(0), policy).best.effect, amount), 5.0 * 50.0, 1e-6);
    policy.max_outside = 1.5;
    EXPECT_NEAR(effect::number(score(fit, unit(0), policy).best.effect, amount), 10.0 * 50.0, 1e-6);
    policy.max_over_residual = 0.2;
    EXPECT_NEAR(effect::number(score(fit, unit(0), policy).best.effect, amount), 2.0 * 50.0, 1e-6);
}

TEST(ProbeScore, HasNonlinearStartsBeyondTheResidual) {
    const JointFit fit = residual_of_two();  // of norm 5
    EXPECT_TRUE(score(fit, 9.9 * unit(0)).nonlinear.empty());
    const EffectScore far = score(fit, 20.0 * unit(0));
    ASSERT_EQ(far.nonlinear.size(), 2u);
    EXPECT_NEAR(effect::number(far.nonlinear[0].effect, amount), 50.0 * 5.0 / 20.0, 1e-9) << "changes by the residual";
    EXPECT_NEAR(effect::number(far.nonlinear[1].effect, amount), 50.0, 1e-9) << "the probe itself";
    ScreeningPolicy policy;
    policy.distinct_start = 5.0;
    EXPECT_EQ(score(fit, 20.0 * unit(0), policy).nonlinear.size(), 1u) << "a factor of four is not distinct";
    const JointFit softer = test::made_fit(-3.0 * unit(0), 40.0 * unit(0) + unit(2));
    const EffectScore compensated = score(softer, 12.0 * unit(0));
    ASSERT_FALSE(compensated.nonlinear.empty());
    EXPECT_LT(compensated.nonlinear[0].step(0), 0.0) << "the modulus moves against the start";
}

/// A softer patch: 5 times the probe of -10 % is possible, 12 times, which leaves no modulus, is not.
TEST(ProbeScore, NegativeAmountsHaveTheirBoundsMirrored) {
    const effect::Effect& patch = *effect::find_effect("soft_patch");
    const effect::EffectProbe softer = effect::probe(
        {{"relative_change", -0.1}, {"centre_m", VectorXd(Eigen::Vector3d(0.05, 0.01, 0.01))}, {"radius_m", 0.02}},
        "relative_change");
    const FitData data = test::made_data(samples);
    const auto score_with = [&](double multiple) {
        const JointFit fit = test::made_fit(-multiple * unit(0), unit(7));
        return score_probe(patch, softer, unit(0), score_reference(fit, data.layout), ScreeningPolicy{});
    };
    const EffectScore half = score_with(5.0), too_much = score_with(12.0);
    EXPECT_NEAR(effect::number(half.best.effect, "relative_change"), -0.5, 1e-9);
    EXPECT_NEAR(half.share(), 1.0, 1e-9);
    EXPECT_LT(too_much.share(), 0.99) << "the bound of the amount limits what the probe explains";
    EXPECT_NEAR(effect::number(score_with(-12.0).best.effect, "relative_change"), 1.2, 1e-9) << "a stiff patch";
}

/// A probe with columns in several directions gets their best combination; a hardly observable direction gets hardly
/// any share of it.
TEST(ProbeScore, JoinsItsColumnsAndDampsHardlyObservableOnes) {
    effect::EffectProbe probe;
    probe.columns = {{{amount, 1.0}}, {{amount, 1.0}}};
    probe.joined = [](const std::vector<effect::EffectParameters>&, const VectorXd& multiples) {
        return effect::EffectParameters{{"multiples", multiples}};
    };
    const JointFit fit = residual_of_two();
    const FitData data = test::made_data(samples);
    const ScoreReference reference = score_reference(fit, data.layout);
    const auto multiples = [&](double second) {
        MatrixXd S(samples, 2);
        S << unit(0), second * unit(1);
        return std::get<VectorXd>(
            score_probe(drag(), probe, S, reference, ScreeningPolicy{}).best.effect.at("multiples"));
    };
    const double damping = std::pow(ScreeningPolicy{}.negligible_column, 2);
    EXPECT_NEAR(multiples(1.0)(0), 3.0 / (1.0 + damping), 1e-6);
    EXPECT_NEAR(multiples(1.0)(1), 4.0 / (1.0 + damping), 1e-6);
    const double small = 0.01;
    EXPECT_NEAR(multiples(small)(1), 4.0 * small / (small * small + damping), 1e-4) << "undamped: 400";
}

}  // namespace
}  // namespace myo::diagnosis::probe_score_test
