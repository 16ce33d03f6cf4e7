#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "diagnosis/fit/candidate_fits.hpp"
#include "diagnosis/made_fits.hpp"
#include "diagnosis/made_problem.hpp"
#include "diagnosis/search/search_decisions.hpp"

// Where candidate fits start, and where their results are entered.

namespace myo::diagnosis::entered_fits_test {
namespace {

using testing::ElementsAre;

/// A score of a probe, with one nonlinear start per amount.
EffectScore score_of(const std::string& id, double share, const std::vector<double>& amounts) {
    EffectScore score;
    score.id = id;
    score.candidate.basis = Eigen::VectorXd::Ones(1);
    score.test.explained = share;
    score.best = {{{"amount", 3.0}}, Eigen::Vector2d(0.1, -0.2)};
    score.probed = {{"amount", 50.0}};
    for (const double amount : amounts)
        score.nonlinear.push_back({{{"amount", amount}}, Eigen::VectorXd::Constant(1, -amount)});
    return score;
}

TEST(CandidateStart, IsTheBestAmountWithTheProbeToFallBackOn) {
    EffectScore score = score_of("drag", 0.4, {});
    score.law = std::make_shared<const effect::Effect>();
    const CandidateStart start = start_of(score);
    EXPECT_EQ(start.effect.id, "drag");
    EXPECT_EQ(start.effect.law, score.law);
    EXPECT_EQ(effect::number(start.effect.parameters, "amount"), 3.0);
    EXPECT_EQ(effect::number(start.safe, "amount"), 50.0);
    EXPECT_EQ(start.step, Eigen::Vector2d(0.1, -0.2));
    EXPECT_EQ(start.predicted_reduction, 0.4);
    EXPECT_FALSE(start.nonlinear);
}

/// Starts of the best probe of each wanted effect, in the order of the identifiers.
TEST(CandidateStart, BeyondTheLinearRangeIsOfTheBestProbe) {
    EffectScore failed = score_of("drag", 0.9, {9.0});
    failed.failure = "the run failed";
    const std::vector<EffectScore> scores{score_of("patch", 0.3, {1.0}),     score_of("drag", 0.2, {2.0}),
                                          score_of("drag", 0.5, {3.0, 4.0}), score_of("drag", 0.5, {5.0}),
                                          score_of("drag", 0.8, {}),         failed,
                                          score_of("mass", 0.7, {6.0})};
    std::vector<std::string> ids;
    std::vector<double> amounts, steps;
    for (const CandidateStart& start : nonlinear_starts(scores, [](const EffectScore& s) { return s.id != "mass"; })) {
        ids.push_back(start.effect.id);
        amounts.push_back(effect::number(start.effect.parameters, "amount"));
        steps.push_back(start.step(0));
        EXPECT_TRUE(start.nonlinear && start.safe.empty());
        EXPECT_EQ(start.predicted_reduction, start.effect.id == "drag" ? 0.5 : 0.3);
    }
    EXPECT_THAT(ids, ElementsAre("drag", "drag", "patch"));
    EXPECT_THAT(amounts, ElementsAre(3.0, 4.0, 1.0));
    EXPECT_THAT(steps, ElementsAre(-3.0, -4.0, -1.0));
}

/// A candidate whose fit leaves so many noise levels; 0: it was not fitted.
Candidate candidate(const std::string& id, double leaves) {
    Candidate made;
    made.score.id = id;
    if (leaves > 0.0) made.judged = test::fit_that_leaves(leaves, id);
    return made;
}

JudgedFit set_of(double leaves, const std::vector<std::string>& ids) {
    JudgedFit set = test::fit_that_leaves(leaves);
    for (const std::string& id : ids) set.fit.effects.push_back({id, {}});
    return set;
}

TEST(EnteredFit, ReplacesAWorseOneOfItsEffect) {
    RankedFits fits;
    fits.candidates = {candidate("drag", 0.0), candidate("mass", 2.0)};
    enter_fit(fits, set_of(3.0, {"drag"}));
    EXPECT_NEAR(left_by(fits.candidates, "drag"), 900.0, 1e-9) << "the first of this effect";
    for (const auto& [entered, leaves] : {std::pair{4.0, 3.0}, {2.5, 2.5}, {2.7, 2.5}}) {
        enter_fit(fits, set_of(entered, {"drag"}));
        EXPECT_NEAR(left_by(fits.candidates, "drag"), 100.0 * leaves * leaves, 1e-9);
    }
    EXPECT_NEAR(left_by(fits.candidates, "mass"), 400.0, 1e-9);
    enter_fit(fits, set_of(0.1, {"tilt"}));
    EXPECT_EQ(fits.candidates.size(), 2u) << "no candidate";
    EXPECT_TRUE(fits.sets.empty());
}

TEST(EnteredFit, OfASetReplacesAWorseOneOfTheSameEffects) {
    RankedFits fits;
    fits.candidates = {candidate("drag", 2.0)};
    enter_fit(fits, set_of(3.0, {"drag", "mass"}));
    enter_fit(fits, set_of(1.0, {"drag", "tilt"}));
    enter_fit(fits, set_of(2.0, {"mass", "drag"}));
    enter_fit(fits, set_of(2.5, {"drag", "mass"}));
    ASSERT_EQ(fits.sets.size(), 2u);
    EXPECT_NEAR(fits.sets[0].fit.squares(), 400.0, 1e-9);
    EXPECT_EQ(fits.sets[0].fit.effects[0].id, "mass");
    EXPECT_NEAR(fits.sets[1].fit.squares(), 100.0, 1e-9);
    EXPECT_NEAR(left_by(fits.candidates, "drag"), 400.0, 1e-9);
}

TEST(BestOfAll, LeavesTheLeastOfTheFirstCandidateAndTheFirstSet) {
    RankedFits fits;
    EXPECT_EQ(best_of_all(fits), nullptr);
    fits.candidates = {candidate("drag", 2.0), candidate("mass", 0.5)};
    EXPECT_EQ(best_of_all(fits), &*fits.candidates[0].judged);
    for (const double leaves : {1.9, 2.0, 2.1}) {
        fits.sets = {set_of(leaves, {"drag", "mass"}), set_of(0.5, {"drag", "tilt"})};
        EXPECT_EQ(best_of_all(fits), leaves < 2.0 ? fits.sets.data() : &*fits.candidates[0].judged) << leaves;
    }
    fits.candidates[0].judged.reset();
    EXPECT_EQ(best_of_all(fits), fits.sets.data());
    fits.sets.clear();
    EXPECT_EQ(best_of_all(fits), nullptr);
}

/// A set is tested by other trials unless a single one determines more of its numbers than of the declared fit.
TEST(Untested, IsASetOfWhichOneTrialTellsMore) {
    JudgedFit declared = test::fit_that_leaves(10.0), set = set_of(1.0, {"drag", "mass"});
    declared.single_trial_directions = set.single_trial_directions = 2;
    EXPECT_FALSE(is_untested(set, declared));
    set.single_trial_directions = 3;
    EXPECT_TRUE(is_untested(set, declared));
    set.fit.effects[1].parameters = {{"trial", 1.0}};
    EXPECT_FALSE(is_untested(set, declared)) << "no other trial could test it";
}

TEST(Evidence, OverAFitThatFailedIsInfinite) {
    const FitData data = test::made_data(100);
    const JudgedFit good = test::fit_that_leaves(1.5), failed;
    EXPECT_TRUE(std::isinf(evidence_ratio(data, good, failed, {})));
    EXPECT_EQ(evidence_ratio(data, failed, good, {}), 0.0);
    EXPECT_TRUE(weights_of(data, {}, {}).empty());
}

}  // namespace
}  // namespace myo::diagnosis::entered_fits_test
