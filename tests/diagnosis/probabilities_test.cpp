#include "diagnosis/verdict/probabilities.hpp"

#include <gtest/gtest.h>

#include "diagnosis/made_fits.hpp"

namespace myo::diagnosis::probabilities_test {
namespace {

using namespace test;

JudgedFit set_of(const std::vector<std::string>& ids, double weight) {
    JudgedFit fit = fit_that_leaves(0.3);
    for (const std::string& id : ids) fit.fit.effects.push_back({id, {}});
    fit.weight = weight;
    return fit;
}

Candidate single(const std::string& id, double weight) {
    Candidate candidate;
    candidate.score.id = id;
    candidate.judged = set_of({id}, weight);
    return candidate;
}

/// Weights of all fits: singles a 0.1, b 0.05, sets ab 0.5, ac 0.2, abc 0.15.
Diagnosis weighed() {
    Diagnosis d;
    d.candidates = {single("a", 0.1), single("b", 0.05), {}};
    d.candidates[2].score.id = "c";
    d.sets = {set_of({"b", "a"}, 0.5), set_of({"a", "c"}, 0.2), set_of({"c", "a", "b"}, 0.15)};
    return d;
}

TEST(Probabilities, ASetIsPresentInLargerOnes) {
    const Diagnosis d = weighed();
    EXPECT_DOUBLE_EQ(presence(d, d.sets[0]), 0.65);
    EXPECT_DOUBLE_EQ(presence(d, d.sets[2]), 0.15);
    EXPECT_DOUBLE_EQ(presence(d, *d.candidates[0].judged), 0.95);
}

TEST(Probabilities, AddUpOverTheFitsInWhichAnEffectActs) {
    Diagnosis d = weighed();
    d.verdict.kind = VerdictKind::effects;
    d.verdict.effects = d.sets[0].fit.effects;
    d.verdict.trust = 0.9;
    d.verdict.confidence = 0.4;
    const std::map<std::string, double> p = effect_probabilities(d);
    EXPECT_DOUBLE_EQ(p.at("a"), 0.9 * 0.95);
    EXPECT_DOUBLE_EQ(p.at("b"), 0.9 * 0.7);
    EXPECT_DOUBLE_EQ(p.at("c"), 0.9 * 0.35);
    EXPECT_DOUBLE_EQ(confidence_in(d, "b"), 0.9 * 0.7);
    d.verdict.confidence = 0.8;
    EXPECT_DOUBLE_EQ(confidence_in(d, "b"), 0.8) << "an effect is as sure as the whole answer, or surer";
}

/// One effect alone has the confidence of the answer; what `unknown` leaves over is shared by the candidates.
TEST(Probabilities, FollowTheKindOfTheAnswer) {
    Diagnosis d = weighed();
    d.verdict.kind = VerdictKind::unknown;
    d.verdict.confidence = 0.9;
    EXPECT_NEAR(effect_probabilities(d).at("a"), 0.1 * 0.95, 1e-15);
    d.verdict.kind = VerdictKind::effects;
    d.verdict.effects = {{"a", {}}};
    d.verdict.confidence = 0.3;
    EXPECT_DOUBLE_EQ(confidence_in(d, "a"), 0.3);
}

}  // namespace
}  // namespace myo::diagnosis::probabilities_test
