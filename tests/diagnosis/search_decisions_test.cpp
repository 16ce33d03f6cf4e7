#include "diagnosis/search/search_decisions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/fit/pruning.hpp"
#include "diagnosis/made_fits.hpp"

namespace myo::diagnosis::search_decisions_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

const SearchPolicy policy;
constexpr double below = 0.999, above = 1.001;

/// A fit of 100 samples with this squared residual beyond the noise.
JudgedFit with_excess(double excess) { return fit_that_leaves(std::sqrt(1.0 + excess / 100.0), "quadratic_drag"); }

TEST(SearchDecisions, AFitFarBetterThanTheDeclaredOneIsCorrected) {
    const JudgedFit declared = with_excess(5000.0);
    for (const bool worth : {true, false}) {
        JudgedFit fit = with_excess((worth ? below : above) * policy.corrected_share * 5000.0);
        EXPECT_EQ(is_worth_correcting(fit, declared, policy), worth);
        fit.numerics.emplace();
        EXPECT_FALSE(is_worth_correcting(fit, declared, policy)) << "its error is known";
    }
}

TEST(SearchDecisions, AFitBySecantsIsPolishedOnce) {
    JudgedFit fit = with_excess(10.0);
    EXPECT_TRUE(is_unpolished(fit));
    fit.fit.report.status = inverse::FitStatus::converged;
    fit.fit.report.jacobians = 1;
    EXPECT_TRUE(is_unpolished(fit)) << "one Jacobian and secants";
    fit.fit.report.jacobians = 2;
    EXPECT_FALSE(is_unpolished(fit));
    fit.fit.report.status = inverse::FitStatus::not_converged;
    EXPECT_TRUE(is_unpolished(fit));
    fit.numerics.emplace();
    EXPECT_FALSE(is_unpolished(fit));
}

TEST(SearchDecisions, RivalsComeCloseToTheBest) {
    Candidate candidate;
    EXPECT_FALSE(is_rival(candidate, 1e9, policy)) << "not fitted";
    candidate.judged = with_excess(200.0);
    const double squares = candidate.judged->fit.squares();
    EXPECT_TRUE(is_rival(candidate, above * squares / policy.rival_factor, policy));
    EXPECT_FALSE(is_rival(candidate, below * squares / policy.rival_factor, policy));
}

std::vector<CandidateStart> starts(const std::vector<double>& reductions) {
    std::vector<CandidateStart> made;
    for (const double reduction : reductions) made.push_back({{"quadratic_drag", {}}, {}, false, reduction, {}});
    return made;
}

TEST(SearchDecisions, AllStartsAreFittedWhileNothingExplains) {
    const JudgedFit declared = with_excess(5000.0);
    EXPECT_EQ(starts_worth_fitting(starts({0.9, 0.1, 0.1, 0.1, 0.1}), nullptr, declared, false, policy), 5u);
    EXPECT_EQ(starts_worth_fitting({}, nullptr, declared, true, policy), 0u);
}

TEST(SearchDecisions, AfterAnExplanationOnlyComparableStartsAreFitted) {
    const JudgedFit declared = with_excess(5000.0);
    const double worth = 0.8 * policy.min_relative_reduction;
    EXPECT_EQ(starts_worth_fitting(starts({0.8, 0.1, 0.1, above * worth, below * worth, 0.1}), nullptr, declared, true,
                                   policy),
              4u);
    EXPECT_EQ(starts_worth_fitting(starts({0.8, 0.1}), nullptr, declared, true, policy), 2u);
    SearchPolicy patient = policy;
    patient.first_fits = 5;
    EXPECT_EQ(starts_worth_fitting(starts({0.8, 0.1, 0.1, 0.1, 0.1, 0.1}), nullptr, declared, true, patient), 5u);
}

/// A fit that removes most and leaves less than the noise ends the search as well.
TEST(SearchDecisions, MostOfTheResidualIsNearlyAnExplanation) {
    const JudgedFit declared = fit_that_leaves(10.0);
    const std::vector<CandidateStart> five = starts({0.8, 0.1, 0.1, 0.1, 0.1});
    const double half = 10.0 * std::sqrt(policy.max_left);
    for (const double share : {below, above})
        for (const double systematic : {below, above}) {
            JudgedFit best = fit_that_leaves(share * half);
            best.tests.systematic.rms = systematic * policy.noise_like;
            EXPECT_EQ(starts_worth_fitting(five, &best, declared, false, policy),
                      share < 1.0 && systematic < 1.0 ? policy.first_fits : 5u);
        }
}

TEST(SearchDecisions, ASetIsTriedWhereTheBestLeavesAnExcess) {
    Diagnosis d = with_candidate(0.3);
    EXPECT_FALSE(is_worth_a_set(*d.candidates[0].judged, d.baseline())) << "one effect explains it";
    d.declared = with_excess(5000.0);
    const double limit = SetPolicy{}.max_left * 5000.0;
    EXPECT_TRUE(is_worth_a_set(with_excess(below * limit), d.baseline()));
    EXPECT_FALSE(is_worth_a_set(with_excess(above * limit), d.baseline()));
}

/// Sets are tried before unlikely starts of single effects where even the best leaves much.
TEST(SearchDecisions, TheSearchIsFarWhereTheBestEffectLeavesMuch) {
    Diagnosis d = with_candidate(0.3);
    EXPECT_FALSE(is_far_from_explained(d.candidates, d.baseline())) << "explained";
    d.declared = with_excess(5000.0);
    for (const bool far : {true, false}) {
        d.candidates[0].judged = with_excess((far ? above : below) * policy.corrected_share * 5000.0);
        EXPECT_EQ(is_far_from_explained(d.candidates, d.baseline()), far);
    }
    d.candidates[0].judged.reset();
    EXPECT_FALSE(is_far_from_explained(d.candidates, d.baseline())) << "nothing was fitted";
    EXPECT_EQ(best_fit(d.candidates), nullptr);
}

/// A set with numbers that a single trial determines is no answer yet.
TEST(SearchDecisions, ASetExplainsIfOtherTrialsTestIt) {
    const Diagnosis d = with_candidate(9.0);
    RankedFits fits;
    fits.candidates = d.candidates;
    EXPECT_FALSE(is_explained(fits, d.baseline()));
    fits.sets = {pair_that_leaves(0.25)};
    EXPECT_TRUE(is_explained(fits, d.baseline()));
    fits.sets[0].single_trial_directions = 1;
    EXPECT_FALSE(is_explained(fits, d.baseline()));
}

TEST(SearchDecisions, OneEffectOfASetIsRemoved) {
    prediction::ParameterValues values;
    values.effects = {{"declared", {}}, {"first", {}}, {"second", {}}};
    const prediction::ParameterValues without = without_effect(values, 1);
    ASSERT_EQ(without.effects.size(), 2u);
    EXPECT_EQ(without.effects[0].id, "declared");
    EXPECT_EQ(without.effects[1].id, "second");
}

std::vector<std::size_t> continued(const PruningInput& in, double predicted = 1e30) {
    return fits_worth_continuing(in, [&](std::size_t) { return predicted; });
}

/// The smallest squared residual is that of noise: the limit is the pruning factor.
TEST(Pruning, EndsFitsAboveAMultipleOfTheSmallest) {
    PruningInput in{{{100.0, 0.9, true}, {400.0 * below, 0.5, true}, {400.0 * above, 0.5, true}}, 1e9, 100.0, 4.0, 0.9};
    EXPECT_THAT(continued(in), ElementsAre(0, 1));
    EXPECT_THAT(continued(in, 400.0 * below), ElementsAre(0, 1, 2)) << "its next step comes close enough";
    EXPECT_THAT(continued(in, 400.0 * above), ElementsAre(0, 1));
    in.fits[0].open = false;
    EXPECT_THAT(continued(in), ElementsAre(1)) << "finished fits still set the limit";
    in.least_so_far = 50.0;
    EXPECT_THAT(continued(in), IsEmpty()) << "an earlier fit does as well";
}

/// While the smallest is three times the noise, the limit is three times as high; never above the factor cubed.
TEST(Pruning, IsLaterWhileTheBestIsFarAboveTheNoise) {
    for (const auto& [noise_over, raised] : {std::pair{1.0, 1.0}, {3.0, 3.0}, {1e6, 4.0}}) {
        const double limit = 2.0 * raised;
        const PruningInput in{
            {{100.0, 0.9, false}, {100.0 * limit * below, 0.5, true}, {100.0 * limit * above, 0.5, true}},
            1e9,
            100.0 / noise_over,
            2.0,
            0.9};
        EXPECT_THAT(continued(in), ElementsAre(1)) << noise_over;
    }
}

TEST(Pruning, IsLaterForEffectsThatPromiseAsMuchAsTheBest) {
    for (const double reduction : {0.9 * 0.8 * above, 0.9 * 0.8 * below}) {
        const PruningInput in{{{100.0, 0.8, false}, {400.0 * below, reduction, true}, {400.0 * above, reduction, true}},
                              1e9,
                              100.0,
                              2.0,
                              0.9};
        if (reduction > 0.72)
            EXPECT_THAT(continued(in), ElementsAre(1));
        else
            EXPECT_THAT(continued(in), IsEmpty());
    }
}

/// A promising fit is not ended by a mimic that leaves three times the noise; by one that leaves noise it is.
TEST(Pruning, KeepsPromisingFitsUntilTheNoiseIsReached) {
    PruningInput in{{{100.0, 0.8, false}, {9000.0, 0.79, true}, {9000.0, 0.5, true}}, 1e9, 100.0 / 3.0, 2.0, 0.9};
    in.noise_like = 2.0;
    EXPECT_THAT(continued(in), IsEmpty());
    in.promising_squares = 9000.0 * above;
    EXPECT_THAT(continued(in), ElementsAre(1)) << "the other effect predicts less";
    in.promising_squares = 9000.0 * below;
    EXPECT_THAT(continued(in), IsEmpty());
    in.promising_squares = 9000.0 * above;
    in.samples = 100.0 / in.noise_like;
    EXPECT_THAT(continued(in), IsEmpty()) << "the best leaves what noise does";
}

/// The raised limits are for fits that remove something: one that leaves all has the pruning factor only.
TEST(Pruning, EndsFitsWithoutProgressAsEarlyAsNearTheNoise) {
    PruningInput in{{{100.0, 0.8, false}, {350.0, 0.79, true}, {150.0, 0.5, true}}, 1e9, 1.0, 2.0, 0.9};
    EXPECT_THAT(continued(in), ElementsAre(1, 2)) << "the best is far above the noise";
    in.stuck_squares = 340.0;
    EXPECT_THAT(continued(in), ElementsAre(2));
    EXPECT_THAT(continued(in, 190.0), ElementsAre(1, 2)) << "its next step comes close enough";
}

TEST(Pruning, AsksForTheNextStepOnlyAboveTheLimit) {
    std::vector<std::size_t> asked;
    const PruningInput in{{{100.0, 0.9, true}, {900.0, 0.1, true}, {900.0, 0.1, false}}, 1e9, 100.0, 4.0, 0.9};
    fits_worth_continuing(in, [&](std::size_t i) {
        asked.push_back(i);
        return 1e30;
    });
    EXPECT_THAT(asked, ElementsAre(1));
}

}  // namespace
}  // namespace myo::diagnosis::search_decisions_test
