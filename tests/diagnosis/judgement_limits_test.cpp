#include <gtest/gtest.h>

#include <limits>

#include "diagnosis/made_fits.hpp"
#include "diagnosis/selection/judgement.hpp"

// Each limit of JudgementPolicy at both of its sides, on made-up fits.

namespace myo::diagnosis::judgement_limits_test {
namespace {

using namespace test;

const JudgementPolicy policy;

/// Declared and candidate fit, all of whose tests are significant.
struct Case {
    explicit Case(double declared_over_noise, double left_over_noise = 0.0) {
        data.noise_m = Eigen::VectorXd::Constant(100, noise_m);
        declared = significant(declared_over_noise);
        fit = significant(left_over_noise);
        fit.held_out_rms = fit.held_out_in_time_rms = 1.0;
    }
    static JudgedFit significant(double over_noise) {
        JudgedFit made = fit_that_leaves(over_noise, "quadratic_drag");
        made.tests.variance.p = 0.0;
        return made;
    }
    Baseline baseline() const { return {declared, data, numerics, settings}; }
    bool explains_it(Leniency leniency = Leniency::tolerant) const { return explains(fit, baseline(), leniency); }

    FitData data;
    NumericalError numerics;
    DiagnoseSettings settings;
    JudgedFit declared, fit;
};

prediction::ModelParameter number(prediction::ModelParameter::Kind kind) {
    prediction::ModelParameter p;
    p.kind = kind;
    p.parameter.lower = 1.0;
    p.parameter.upper = 100.0;
    if (kind == prediction::ModelParameter::Kind::effect) p.of_effect = "coefficient_kg_m3";
    return p;
}

constexpr double below = 0.999, above = 1.001;

TEST(JudgementLimits, NumericalAllowanceFollowsTheDoubtOfTheExtrapolation) {
    const Case of(1.0);
    const auto allowance = [&](double left_over_noise) {
        NumericalError error;
        error.left_rms_m = left_over_noise * noise_m;
        return numerical_allowance(of.data, error, policy);
    };
    EXPECT_DOUBLE_EQ(allowance(0.0), policy.min_systematic);
    EXPECT_DOUBLE_EQ(allowance(0.2), policy.rough_extrapolation * 0.2);
    EXPECT_DOUBLE_EQ(allowance(0.5), policy.max_rough);
    EXPECT_DOUBLE_EQ(allowance(0.9), 0.9);
    EXPECT_DOUBLE_EQ(allowance(7.0), policy.max_allowed);
}

TEST(JudgementLimits, AResidualNeedsAnExplanationAboveTheAllowance) {
    EXPECT_FALSE(needs_explanation(Case(below * policy.min_systematic).baseline()));
    EXPECT_TRUE(needs_explanation(Case(above * policy.min_systematic).baseline()));
    Case silent(2.0);
    silent.declared.tests.variance.p = 1.0;
    EXPECT_FALSE(needs_explanation(silent.baseline())) << "not significant";
    Case drift(2.0);
    drift.declared.independence = {0.5, 1.0, 0.0};
    EXPECT_FALSE(needs_explanation(drift.baseline())) << "measurement drift";
}

TEST(JudgementLimits, FaintIsBelowAShareOfNoiseOrMesh) {
    EXPECT_TRUE(is_faint(Case(below * policy.faint).baseline()));
    EXPECT_FALSE(is_faint(Case(above * policy.faint).baseline()));
    for (const double mesh : {0.9, 5.0}) {  // noise levels
        const double limit = std::min(policy.max_faint, policy.faint_share_of_mesh * mesh);
        ASSERT_GT(limit, policy.faint);
        for (const bool faint : {true, false}) {
            Case of((faint ? below : above) * limit);
            of.numerics.mesh_rms_m = mesh * noise_m;
            EXPECT_EQ(is_faint(of.baseline()), faint) << mesh;
        }
    }
}

TEST(JudgementLimits, AnExplanationPredictsHeldOutData) {
    const double declared = 2.0, limit = std::sqrt(1.0 + policy.max_held_out * (declared * declared - 1.0));
    for (const bool in_time : {false, true})
        for (const bool good : {true, false}) {
            Case of(3.0, 0.1);
            of.declared.held_out_rms = of.declared.held_out_in_time_rms = declared;
            (in_time ? of.fit.held_out_in_time_rms : of.fit.held_out_rms) = (good ? below : above) * limit;
            of.fit.single_trial_directions = in_time ? 1 : 0;
            EXPECT_EQ(may_explain(of.fit, of.baseline()), good) << in_time;
            // The other of the two errors is not what counts.
            (in_time ? of.fit.held_out_rms : of.fit.held_out_in_time_rms) = 100.0;
            EXPECT_EQ(may_explain(of.fit, of.baseline()), good) << in_time;
        }
    for (const bool good : {true, false}) {
        Case of(3.0, 0.1);  // that predicts held-out data perfectly
        of.declared.held_out_rms = 1.0;
        of.fit.held_out_rms = std::sqrt(1.0 + (good ? below : above) * policy.chance_held_out);
        EXPECT_EQ(may_explain(of.fit, of.baseline()), good);
    }
}

TEST(JudgementLimits, AnAmountDiffersFromZeroByDeviations) {
    JointFit fit;
    fit.parameters = {number(prediction::ModelParameter::Kind::effect)};
    fit.values.effects = fit.effects = {{"quadratic_drag", {{"coefficient_kg_m3", 30.0}}}};
    EXPECT_TRUE(differs_from_zero(fit, policy)) << "no deviations";
    for (const bool differs : {true, false}) {
        fit.report.deviations = Eigen::VectorXd::Constant(
            1, (differs ? below : above) * 30.0 / policy.significant_deviations);
        EXPECT_EQ(differs_from_zero(fit, policy), differs);
    }
    fit.report.deviations(0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(differs_from_zero(fit, policy)) << "not determined by the data";
    fit.effects.clear();  // declared, not tried
    EXPECT_TRUE(differs_from_zero(fit, policy));
}

/// An effect with several numbers is judged by its first one, the amount; several effects by the amount of each.
TEST(JudgementLimits, EveryTriedEffectHasToDiffer) {
    JointFit fit;
    const effect::EffectDeclaration drag{"quadratic_drag", {{"coefficient_kg_m3", 30.0}, {"place", 0.1}}};
    fit.values.effects = fit.effects = {drag, drag};
    prediction::ModelParameter amount = number(prediction::ModelParameter::Kind::effect), place = amount;
    place.of_effect = "place";
    fit.parameters = {amount, place, amount};
    fit.parameters[2].index = 1;
    fit.report.deviations = Eigen::Vector3d(1.0, 100.0, 1.0);
    EXPECT_TRUE(differs_from_zero(fit, policy)) << "the place may be anywhere";
    fit.report.deviations = Eigen::Vector3d(1.0, 0.001, 100.0);
    EXPECT_FALSE(differs_from_zero(fit, policy)) << "the second effect may be absent";
    fit.effects = {drag};
    EXPECT_FALSE(differs_from_zero(fit, policy));
    fit.report.deviations = Eigen::Vector3d(100.0, 0.001, 1.0);
    EXPECT_TRUE(differs_from_zero(fit, policy)) << "the first effect is declared";
}

TEST(JudgementLimits, BoundsAreReachedWithinATolerance) {
    for (const auto kind :
         {prediction::ModelParameter::Kind::youngs_modulus, prediction::ModelParameter::Kind::effect}) {
        const bool modulus = kind == prediction::ModelParameter::Kind::youngs_modulus;
        JointFit fit;
        fit.parameters = {number(kind)};
        for (const auto& [value, at_bound] :
             {std::pair{1.0, true}, {1.0 + 1e-5, false}, {50.0, false}, {100.0 * (1.0 - 1e-5), false}, {100.0, true}}) {
            fit.values.youngs_modulus_Pa = value;
            fit.values.effects = {{"quadratic_drag", {{"coefficient_kg_m3", value}}}};
            EXPECT_EQ(modulus_at_bound(fit, policy), modulus && at_bound) << value;
            EXPECT_EQ(effect_at_bound(fit, policy), !modulus && at_bound) << value;
        }
    }
    JudgementPolicy wide;
    wide.at_bound = 0.1;
    JointFit near;
    near.parameters = {number(prediction::ModelParameter::Kind::youngs_modulus)};
    near.values.youngs_modulus_Pa = 95.0;
    EXPECT_TRUE(modulus_at_bound(near, wide)) << "within a tenth";
    EXPECT_FALSE(modulus_at_bound(near, policy));
    JointFit place;
    place.parameters = {number(prediction::ModelParameter::Kind::effect)};
    place.parameters[0].component = 1;
    place.values.effects = {{"quadratic_drag", {{"coefficient_kg_m3", Eigen::VectorXd(Eigen::Vector3d::Ones())}}}};
    EXPECT_FALSE(effect_at_bound(place, policy)) << "a component of a place";
}

TEST(JudgementLimits, AnExplanationTakesMostAway) {
    for (const double was : {0.45, 2.0}) {
        const double share = was < policy.faint ? policy.most_of_faint : policy.most_of_residual;
        for (const bool most : {true, false}) {
            Case of(was, (most ? below : above) * share * was);
            of.fit.tests.variance.p = 1.0;  // so that nothing is left to be tolerated
            EXPECT_EQ(of.explains_it(), most) << was;
            EXPECT_EQ(of.explains_it(Leniency::strict), most) << was;
        }
    }
}

/// What a significant remainder may be due to, one reason at a time.
TEST(JudgementLimits, ToleranceOfARemainder) {
    struct Reason {
        const char* name;
        double was, left_rms, mesh_rms, limit;  // noise levels
    };
    for (const Reason& reason :
         {Reason{"two simulators", 2.0, 0.0, 0.0, policy.min_systematic},
          Reason{"mesh error", 10.0, 0.8, 0.0, policy.mesh_error_factor * 0.8},
          Reason{"mesh error at its limit", 10.0, 5.0, 0.0, policy.mesh_error_factor * policy.max_allowed},
          Reason{"other form", 20.0, 0.0, 0.0, policy.share_of_form * 20.0},
          Reason{"whole mesh", 2.0, 0.0, 1.2, policy.share_of_mesh * 1.2},
          Reason{"whole mesh at its limit", 2.0, 0.0, 9.0, policy.most_of_mesh}})
        for (const bool tolerated : {true, false}) {
            Case of(reason.was, (tolerated ? below : above) * reason.limit);
            of.numerics.left_rms_m = reason.left_rms * noise_m;
            of.numerics.mesh_rms_m = reason.mesh_rms * noise_m;
            EXPECT_EQ(of.explains_it(), tolerated) << reason.name;
        }
}

TEST(JudgementLimits, StrictToleratesTheDoubtOnly) {
    for (const bool tolerated : {true, false}) {
        Case of(20.0, (tolerated ? below : above) * 0.8);
        of.numerics.left_rms_m = 0.8 * noise_m;
        of.numerics.mesh_rms_m = 9.0 * noise_m;
        EXPECT_EQ(of.explains_it(Leniency::strict), tolerated);
        EXPECT_TRUE(of.explains_it());
    }
}

TEST(JudgementLimits, TheWholeMeshExcusesOnlyALittle) {
    for (const bool little : {true, false}) {
        const double left = 0.4;  // less than a third of the mesh error
        Case of(left / policy.little_left * (little ? above : below), left);
        of.numerics.mesh_rms_m = 1.5 * noise_m;
        EXPECT_EQ(of.explains_it(), little);
    }
}

TEST(JudgementLimits, ChanceMayAddToTheRemainder) {
    const double deviation = 0.1, limit = policy.min_systematic + policy.chance_deviations * deviation;
    for (const bool chance : {true, false}) {
        Case of(2.0, (chance ? below : above) * limit);
        of.fit.tests.systematic.deviation = deviation;
        EXPECT_EQ(of.explains_it(), chance);
        EXPECT_FALSE(of.explains_it(Leniency::strict));
    }
}

/// The error of a fit itself counts, where it was computed.
TEST(JudgementLimits, AFitIsJudgedByItsOwnNumericalError) {
    Case of(10.0, 1.0);
    of.numerics.left_rms_m = 0.8 * noise_m;
    EXPECT_TRUE(of.explains_it());
    of.fit.numerics.emplace();
    EXPECT_FALSE(of.explains_it());
    of.fit.numerics->left_rms_m = 0.8 * noise_m;
    EXPECT_TRUE(of.explains_it());
}

}  // namespace
}  // namespace myo::diagnosis::judgement_limits_test
