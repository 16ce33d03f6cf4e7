#include <gtest/gtest.h>

#include "diagnosis/made_fits.hpp"
#include "diagnosis/verdict/verdict_rules.hpp"

// Each threshold of the verdict's rules at both of its sides.

namespace myo::diagnosis::verdict_limits_test {
namespace {

using namespace test;

const VerdictPolicy policy;
constexpr double below = 0.999, above = 1.001;

std::string rule_of(const Diagnosis& d) { return decide(d).verdict.rule; }

/// Noise of still markers, which nobody declared.
Diagnosis measured(double left) {
    Diagnosis d = with_candidate(left);
    d.data.noise_declared = false;
    return d;
}

TEST(VerdictLimits, NothingIsMissingBelowTheAllowance) {
    for (const bool missing : {false, true}) {
        Diagnosis d = with_candidate(0.1);
        d.declared = fit_that_leaves((missing ? above : below) * JudgementPolicy{}.min_systematic);
        d.declared.tests.variance.p = 0.0;
        EXPECT_EQ(rule_of(d), missing ? "single_effect" : "nothing_missing");
    }
}

TEST(VerdictLimits, DriftIsUncorrelatedBetweenMarkers) {
    for (const bool correlated : {false, true}) {
        Diagnosis d = with_candidate(0.3);
        d.declared = fit_that_leaves(2.0);
        d.declared.independence = {correlated ? 0.009 : 0.011, 1.0, 0.0};
        EXPECT_EQ(rule_of(d), correlated ? "single_effect" : "drift");
    }
}

TEST(VerdictLimits, OneEffectRemovesNearlyAll) {
    for (const bool nearly : {true, false})
        EXPECT_EQ(rule_of(with_candidate((nearly ? below : above) * policy.nearly_all * 10.0)),
                  nearly ? "nearly_all" : "unexplained");
    for (const bool present : {true, false}) {
        Diagnosis d = with_candidate(1.23);
        d.candidates[0].judged->weight = (present ? above : below) * policy.present;
        EXPECT_EQ(rule_of(d), present ? "nearly_all" : "unexplained");
    }
}

/// An effect is present with the weights of all fits that contain it.
TEST(VerdictLimits, PairsCountForThePresenceOfAnEffect) {
    for (const bool present : {true, false}) {
        Diagnosis d = with_candidate(1.23);
        d.candidates[0].judged->weight = 0.3;
        d.sets = {pair_that_leaves(1.3), pair_that_leaves(1.3)};
        d.sets[0].weight = 0.1;
        d.sets[1].weight = (present ? above : 0.9) * (policy.present - 0.4);
        EXPECT_EQ(rule_of(d), present ? "nearly_all" : "unexplained");
        d.sets[1].fit.effects[0].id = "gravity_tilt";
        EXPECT_EQ(rule_of(d), "unexplained");
    }
}

TEST(VerdictLimits, ThePairExplainsWhatNoSingleEffectDoes) {
    for (const bool explains : {true, false}) {
        Diagnosis d = with_candidate(4.0);
        d.sets = {pair_that_leaves((explains ? below : above) * JudgementPolicy{}.share_of_form * 10.0)};
        d.sets[0].tests.variance.p = 0.0;
        EXPECT_EQ(rule_of(d), explains ? "set" : "unexplained");
    }
    for (const bool needed : {true, false}) {
        Diagnosis d = with_candidate(1.4);
        d.sets = {pair_that_leaves((needed ? below : above) * JudgementPolicy{}.most_of_residual * 1.4)};
        EXPECT_EQ(rule_of(d), needed ? "set" : "unexplained") << "the second effect has to do something";
    }
}

TEST(VerdictLimits, WhichEffectIsSecondHasToBeDecided) {
    for (const bool decided : {true, false}) {
        Diagnosis d = with_candidate(1.23);
        d.sets = {pair_that_leaves(0.2)};
        d.sets[0].weight = (decided ? above : below) * policy.second_effect;
        EXPECT_EQ(rule_of(d), decided ? "set" : "nearly_all");
    }
}

TEST(VerdictLimits, MostIsRemovedOfWhatNoDeclaredNoiseBounds) {
    const auto changed = [](double JudgedFit::*rms, double value) {
        Diagnosis d = measured(4.0);
        (*d.candidates[0].judged).*rms = value;
        return d;
    };
    for (const bool most : {true, false}) {
        const double side = most ? below : above;
        const std::string expected = most ? "most_by_single" : "unexplained";
        EXPECT_EQ(rule_of(changed(&JudgedFit::rms_m, side * policy.max_left * 10.0 * noise_m)), expected);
        EXPECT_EQ(rule_of(changed(&JudgedFit::held_out_rms, side * policy.max_left_held_out * 10.0)), expected);
        Diagnosis in_time = changed(&JudgedFit::held_out_in_time_rms, side * policy.max_left_held_out * 10.0);
        EXPECT_EQ(rule_of(in_time), "most_by_single") << "other trials test all numbers";
        in_time.candidates[0].judged->single_trial_directions = 1;
        EXPECT_EQ(rule_of(in_time), expected);
    }
    EXPECT_EQ(rule_of(with_candidate(4.0)), "unexplained") << "with a declared noise";
}

TEST(VerdictLimits, APairRemovesMostIfItRanksFirst) {
    for (const bool first : {true, false}) {
        Diagnosis d = measured(4.9);
        d.sets = {pair_that_leaves(2.5)};
        d.sets[0].criterion = d.candidates[0].judged->criterion * (first ? below : above);
        EXPECT_EQ(rule_of(d), first ? "most_by_set" : "most_by_single");
    }
}

TEST(VerdictLimits, AFaintResidualIsNotMissed) {
    for (const bool faint : {true, false}) {
        Diagnosis d = with_candidate(0.45);
        d.declared = fit_that_leaves((faint ? below : above) * JudgementPolicy{}.faint);
        d.declared.tests.variance.p = d.candidates[0].judged->tests.variance.p = 0.0;
        EXPECT_EQ(rule_of(d), faint ? "faint" : "unexplained");
    }
}

TEST(VerdictLimits, ConfidencesFollowTheirFormulas) {
    const Decision nearly = decide(with_candidate(1.23));
    EXPECT_NEAR(nearly.verdict.confidence, policy.undoubted * policy.other_form * 0.9, 1e-12);
    const Decision most = decide(measured(4.0));
    EXPECT_NEAR(most.verdict.confidence, policy.undoubted * 0.9 * (1.0 - policy.discount_of_left * 0.4), 1e-12);
    for (const double left : {2.0, 8.0})
        EXPECT_NEAR(decide(with_candidate(left)).verdict.confidence,
                    policy.undoubted * std::min(1.0, policy.nearly_explained + policy.unexplained_growth * left / 10.0),
                    1e-12);
    for (const double declared : {0.1, 0.29}) {
        Diagnosis none = with_candidate(0.05);
        none.declared = fit_that_leaves(declared);
        EXPECT_NEAR(decide(none).verdict.confidence, policy.undoubted, 1e-12) << "nothing is significant";
        none.declared.tests.variance.p = 0.0;
        const double share = declared / JudgementPolicy{}.min_systematic;
        EXPECT_NEAR(decide(none).verdict.confidence,
                    policy.undoubted * std::clamp(policy.faint_allowance - share, policy.min_faint, 1.0), 1e-12);
    }
}

TEST(VerdictLimits, TheFitOfAVerdictIsTheOneItNames) {
    const auto effects = [](const Diagnosis& d) { return decide(d).fit.fit.effects.size(); };
    Diagnosis d = with_candidate(4.0);
    EXPECT_EQ(effects(d), 1u) << "the best attempt";
    d.sets = {pair_that_leaves(3.0)};
    d.sets[0].criterion = 3.0;
    EXPECT_EQ(effects(d), 2u) << "the better attempt";
    d.sets[0].criterion = 5.0;
    EXPECT_EQ(effects(d), 1u);
    d.sets[0] = pair_that_leaves(0.3);
    EXPECT_EQ(effects(d), 2u);
    d.candidates.clear();
    d.sets.clear();
    EXPECT_EQ(effects(d), 0u) << "the declared model";
    d.declared = fit_that_leaves(0.1);
    EXPECT_EQ(effects(d), 0u);
}

/// The verdict first, then all candidates, then what remains of `unknown` and `none`.
TEST(VerdictLimits, RankingHoldsEveryIdOnce) {
    Diagnosis d = with_candidate(0.3);
    for (const char* id : {"linear_drag", "gravity_tilt"}) {
        d.candidates.emplace_back();
        d.candidates.back().score.id = id;
    }
    using Ids = std::vector<std::string>;
    EXPECT_EQ(decide(d).verdict.ranking, (Ids{"quadratic_drag", "linear_drag", "gravity_tilt", "unknown", "none"}));
    d.candidates[0].judged = fit_that_leaves(8.0, "quadratic_drag");
    EXPECT_EQ(decide(d).verdict.ranking, (Ids{"unknown", "quadratic_drag", "linear_drag", "gravity_tilt", "none"}));
    d.declared = fit_that_leaves(0.1);
    EXPECT_EQ(decide(d).verdict.ranking, (Ids{"none", "quadratic_drag", "linear_drag", "gravity_tilt", "unknown"}));
}

TEST(VerdictLimits, NotesErrorsAboveTheNoise) {
    for (const bool noted : {false, true}) {
        Diagnosis d = with_candidate(0.3);
        d.numerics.left_rms_m = (noted ? above : below) * noise_m;
        EXPECT_EQ(decide(d).notes.size(), noted ? 1u : 0u);
    }
}

TEST(VerdictLimits, DecidingChangesNothing) {
    const Diagnosis d = with_candidate(0.3);
    const Decision decision = decide(d);
    EXPECT_TRUE(d.verdict.ranking.empty() && d.verdict.reason.empty() && d.notes.empty());
    EXPECT_EQ(decision.verdict.kind, VerdictKind::effects);
}

}  // namespace
}  // namespace myo::diagnosis::verdict_limits_test
