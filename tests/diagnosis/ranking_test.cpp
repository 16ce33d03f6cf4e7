#include "diagnosis/selection/ranking.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/made_fits.hpp"
#include "diagnosis/made_problem.hpp"

namespace myo::diagnosis::ranking_test {
namespace {

using namespace test;
using testing::ElementsAre;

constexpr int samples = 100;

/// A residual without memory, of this rms.
Eigen::VectorXd noise(double rms) {
    Eigen::VectorXd r(samples);
    for (int k = 0; k < samples; ++k) r(k) = std::sin(static_cast<double>(k * k));
    return r * (rms * std::sqrt(samples) / r.norm());
}

JudgedFit fit(double rms, double held_out, std::size_t parameters = 0) {
    JudgedFit made = fit_that_leaves(rms);
    made.fit.residual = noise(rms);
    made.fit.parameters.resize(parameters);
    made.held_out_rms = made.held_out_in_time_rms = held_out;
    return made;
}

Candidate candidate(const std::string& id, double rms, double share = 0.5) {
    Candidate made;
    made.score.id = id;
    made.score.candidate.kept = made.score.candidate.basis = Eigen::VectorXd::Ones(1);
    made.score.test.explained = share;
    if (rms > 0.0) {
        made.judged = fit(rms, rms);
        made.judged->fit.effects = {{id, {}}};
    }
    return made;
}

/// What candidates leave of ten noise levels.
struct Case {
    FitData data = made_data(samples);
    JudgedFit declared = fit(10.0, 10.0);
    NumericalError numerics;
    DiagnoseSettings settings;
    Baseline baseline() const { return {declared, data, numerics, settings}; }
};

std::vector<std::string> ids_of(const std::vector<Candidate>& candidates) {
    std::vector<std::string> ids;
    for (const Candidate& c : candidates) ids.push_back(c.score.id);
    return ids;
}

/// With white residuals all samples are independent, so that the criterion has a closed form.
TEST(Weights, AreThoseOfTheInformationCriteria) {
    const FitData data = made_data(samples);
    const JudgedFit best = fit(1.0, 1.1), worse = fit(1.3, 1.2, 2);
    const std::vector<FitWeight> weights = weights_of(data, {&best, &worse}, JudgementPolicy{});
    EXPECT_NEAR(weights[0].criterion, 0.5 * samples * (0.0 + std::log(1.1 * 1.1)), 1e-6);
    EXPECT_NEAR(weights[1].criterion,
                0.5 * (samples * (std::log(1.3 * 1.3) + std::log(1.2 * 1.2)) + 2.0 * std::log(samples)), 1e-6);
    const double difference = weights[1].criterion - weights[0].criterion;
    EXPECT_NEAR(weights[1].weight / weights[0].weight, std::exp(-0.5 * difference / JudgementPolicy{}.temperature),
                1e-9);
    EXPECT_NEAR(weights[0].weight + weights[1].weight, 1.0, 1e-12);
}

TEST(Weights, OfFitsThatFailedAreZero) {
    JudgedFit broken;
    const JudgedFit good = fit(1.0, 1.0);
    const std::vector<FitWeight> weights = weights_of(made_data(samples), {&broken, &good}, JudgementPolicy{});
    EXPECT_EQ(weights[0].weight, 0.0);
    EXPECT_TRUE(std::isinf(weights[0].criterion));
    EXPECT_EQ(weights[1].weight, 1.0);
    EXPECT_EQ(weights_of(made_data(samples), {&broken}, JudgementPolicy{})[0].weight, 0.0);
}

TEST(Weights, AmongOthersCountOnlyThem) {
    JudgedFit a = fit(1.0, 1.0), b = a, c = a;
    a.criterion = b.criterion = 5.0;
    c.criterion = 5.0 + 2.0 * JudgementPolicy{}.temperature * std::log(3.0);
    EXPECT_NEAR(weight_among(a, {&b}, JudgementPolicy{}), 0.5, 1e-12);
    EXPECT_NEAR(weight_among(a, {&c}, JudgementPolicy{}), 0.75, 1e-12);
    EXPECT_EQ(weight_among(a, {}, JudgementPolicy{}), 1.0);
}

TEST(Ranking, PutsExplanationsFirstThenFitsThenScores) {
    const Case of;
    RankedFits fits;
    fits.candidates = {candidate("point_mass", 0.0, 0.2), candidate("linear_drag", 4.0),
                       candidate("soft_patch", 0.0, 0.7), candidate("quadratic_drag", 1.0),
                       candidate("gravity_tilt", 2.5)};
    const RankedFits ranked = with_ranked_candidates(fits, of.baseline());
    EXPECT_THAT(ids_of(ranked.candidates),
                ElementsAre("quadratic_drag", "gravity_tilt", "linear_drag", "soft_patch", "point_mass"));
    EXPECT_GT(ranked.candidates[0].judged->weight, ranked.candidates[1].judged->weight);
    double sum = ranked.declared.weight;
    for (int k = 0; k < 3; ++k) sum += ranked.candidates[static_cast<std::size_t>(k)].judged->weight;
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_LT(ranked.declared.weight, 1e-6);
    EXPECT_EQ(ids_of(fits.candidates).front(), "point_mass") << "the input is left as it was";
}

TEST(Ranking, OfPairsWeighsAllFitsTogether) {
    const Case of;
    RankedFits fits;
    fits.candidates = {candidate("quadratic_drag", 3.0)};
    fits.sets = {fit(2.0, 2.0), fit(1.0, 1.0), fit(1.5, 1.5)};
    const RankedFits ranked = with_ranked_sets(fits, of.baseline());
    EXPECT_NEAR(ranked.sets[0].held_out_rms, 1.0, 0.0);
    EXPECT_NEAR(ranked.sets[1].held_out_rms, 1.5, 0.0);
    EXPECT_NEAR(ranked.sets[2].held_out_rms, 2.0, 0.0);
    const double sum = ranked.declared.weight + ranked.candidates[0].judged->weight + ranked.sets[0].weight +
                       ranked.sets[1].weight + ranked.sets[2].weight;
    EXPECT_NEAR(sum, 1.0, 1e-12);
    // Without the pairs the single effect has all the weight, and the pairs keep what they have.
    const RankedFits single = with_ranked_candidates(ranked, of.baseline());
    EXPECT_GT(single.candidates[0].judged->weight, 0.9);
    EXPECT_EQ(single.sets[0].weight, ranked.sets[0].weight);
}

TEST(Ranking, KnowsWhatIsLeft) {
    const std::vector<Candidate> candidates{candidate("point_mass", 0.0), candidate("linear_drag", 3.0),
                                            candidate("gravity_tilt", 2.0)};
    EXPECT_NEAR(left_by(candidates, "linear_drag"), 9.0 * samples, 1e-9);
    EXPECT_NEAR(min_left(candidates), 4.0 * samples, 1e-9);
    EXPECT_TRUE(std::isinf(left_by(candidates, "point_mass")));
    EXPECT_TRUE(std::isinf(left_by(candidates, "clock_offset")));
    EXPECT_TRUE(std::isinf(min_left({candidates[0]})));
}

TEST(Ranking, IsExplainedByTheFirstCandidateOnly) {
    const Case of;
    EXPECT_FALSE(explained({}, of.baseline()));
    EXPECT_FALSE(explained({candidate("point_mass", 0.0), candidate("quadratic_drag", 1.0)}, of.baseline()));
    EXPECT_TRUE(explained({candidate("quadratic_drag", 1.0), candidate("linear_drag", 4.0)}, of.baseline()));
    EXPECT_FALSE(explained({candidate("linear_drag", 4.0), candidate("quadratic_drag", 1.0)}, of.baseline()));
}

/// Two fits are compared by themselves, so that the ratio is the inverse of that of the other one over the first.
TEST(Weights, RatioOfTwoFitsIsThatOfTheirWeights) {
    const FitData data = made_data(samples);
    const JudgedFit better = fit(1.0, 1.0), worse = fit(1.3, 1.3);
    const std::vector<FitWeight> weights = weights_of(data, {&better, &worse}, {});
    EXPECT_DOUBLE_EQ(evidence_ratio(data, better, worse, {}), weights[0].weight / weights[1].weight);
    EXPECT_NEAR(evidence_ratio(data, better, worse, {}) * evidence_ratio(data, worse, better, {}), 1.0, 1e-12);
}

TEST(Sets, AreTheSameInAnyOrder) {
    EXPECT_TRUE(have_same_ids({{"a", {}}, {"b", {}}}, {{"b", {}}, {"a", {}}}));
    EXPECT_FALSE(have_same_ids({{"a", {}}, {"b", {}}}, {{"a", {}}}));
    EXPECT_FALSE(have_same_ids({{"a", {}}, {"b", {}}}, {{"a", {}}, {"c", {}}}));
}

/// A set that leaves a part unexplained comes after one that explains, whatever its criterion.
TEST(Sets, ThoseThatExplainComeFirst) {
    Case made;
    RankedFits fits;
    for (const double leaves : {0.9, 0.2}) {
        JudgedFit set = fit_that_leaves(leaves < 0.5 ? 0.2 : 3.0, "a");
        set.fit.residual = noise(leaves);
        set.held_out_rms = set.held_out_in_time_rms = leaves < 0.5 ? 1.0 : 0.5;
        fits.sets.push_back(set);
    }
    const RankedFits ranked = with_ranked_sets(fits, made.baseline());
    EXPECT_NEAR(ranked.sets[0].tests.systematic.rms, 0.2, 0.0);
    EXPECT_NEAR(ranked.sets[1].tests.systematic.rms, 3.0, 0.0);
}

}  // namespace
}  // namespace myo::diagnosis::ranking_test
