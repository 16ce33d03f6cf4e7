#include "diagnosis/diagnosis.hpp"

#include <gtest/gtest.h>

#include "diagnosis/made_problem.hpp"

namespace myo::diagnosis {
namespace {

/// An effect whose score predicts a change along one axis of three, and a fit that removes these from a residual of
/// ones.
Candidate candidate(const std::string& id, Eigen::Index axis, const Eigen::Vector3d& taken_off, double weight) {
    Candidate made;
    made.score.id = id;
    made.score.candidate.basis = Eigen::Vector3d::Unit(axis);
    made.score.candidate.to_step = Eigen::MatrixXd::Ones(1, 1);
    made.score.candidate.kept = Eigen::VectorXd::Ones(1);
    made.score.candidate.length = Eigen::VectorXd::Ones(1);
    made.score.test.explained = 0.9;
    made.judged.emplace();
    made.judged->fit.residual = Eigen::Vector3d::Ones() - taken_off;
    made.judged->weight = weight;
    return made;
}

Diagnosis of(const std::vector<Candidate>& candidates) {
    Diagnosis d;
    d.declared.fit.residual = Eigen::Vector3d::Ones();
    d.confusions = find_confusions(candidates, d.declared.fit, ConfusionPolicy{});
    d.candidates = with_confusions(candidates, d.confusions);
    return d;
}

TEST(Confusion, IsWhatScoresPredictAlike) {
    const Diagnosis d = of({candidate("clock_offset", 0, {1.0, 0.0, 0.0}, 0.9),
                            candidate("actuation_lag", 0, {0.0, 1.0, 0.0}, 0.0),
                            candidate("added_mass", 1, {0.0, 1.0, 0.0}, 0.0)});
    ASSERT_EQ(d.confusions.size(), 1u);
    EXPECT_EQ(d.confusions[0].first, "clock_offset");
    EXPECT_EQ(d.confusions[0].second, "actuation_lag");
    EXPECT_EQ(d.candidates[1].confounded_with, (std::vector<std::string>{"clock_offset"}));
}

TEST(Confusion, IsAlsoWhatFitsAlike) {
    const Eigen::Vector3d nearly{1.0, 0.1, 0.0};
    const auto with_weight = [&](double weight) {
        return of(
            {candidate("clock_offset", 0, {1.0, 0.0, 0.0}, 0.6), candidate("actuation_delay", 1, nearly, weight)});
    };
    ASSERT_EQ(with_weight(0.4).confusions.size(), 1u);
    EXPECT_NEAR(with_weight(0.4).confusions[0].cosine, nearly.normalized()(0), 1e-12);
    Candidate unforeseen = candidate("actuation_delay", 1, nearly, 0.4);
    unforeseen.score.test.explained = 0.05;  // of its probe; the fit found more
    EXPECT_EQ(of({candidate("clock_offset", 0, {1.0, 0.0, 0.0}, 0.6), unforeseen}).confusions.size(), 1u);
    EXPECT_TRUE(with_weight(0.001).confusions.empty()) << "data that choose clearly between two fits tell them apart";
}

TEST(Confusion, IsDecidedWhereTheFitsChoose) {
    const auto named_first = [](double weight) {
        Diagnosis d = of({candidate("clock_offset", 0, {1.0, 0.0, 0.0}, 0.9),
                          candidate("actuation_lag", 0, {0.9, 0.0, 0.0}, weight)});
        d.verdict.effects = {{"clock_offset", {}, false}};
        return d;
    };
    for (const double weight : {0.0, 0.01, 0.1}) {
        Diagnosis d = named_first(weight);
        ASSERT_EQ(d.confusions.size(), 1u);
        EXPECT_EQ(is_decided(d, d.confusions[0]), weight < 0.05) << weight;
        d.candidates[1].judged.reset();
        EXPECT_FALSE(is_decided(d, d.confusions[0])) << "what was never fitted is not refuted";
        d.verdict.kind = VerdictKind::effects;
        EXPECT_EQ(confusions_of_verdict(d).size(), 1u);
        d.verdict.effects = {{"added_mass", {}, false}};
        EXPECT_TRUE(confusions_of_verdict(d).empty()) << "says nothing of the answer";
        EXPECT_FALSE(is_decided(d, d.confusions[0]));
    }
}

constexpr double confusion_below = 0.999, confusion_above = 1.001;

/// Score along a direction at this cosine to the first axis.
Candidate at_cosine(const std::string& id, double cosine) {
    Candidate made = candidate(id, 0, Eigen::Vector3d::Zero(), 0.0);
    made.score.candidate.basis = Eigen::Vector3d(cosine, std::sqrt(1.0 - cosine * cosine), 0.0);
    return made;
}

std::size_t confusions(const Candidate& a, const Candidate& b) {
    const JointFit declared = test::made_fit(Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero());
    return find_confusions({a, b}, declared, ConfusionPolicy{}).size();
}

TEST(Confusion, BeginsAtACosine) {
    const double limit = ConfusionPolicy{}.min_cosine;
    for (const double sign : {1.0, -1.0}) {
        EXPECT_EQ(
            confusions(at_cosine("linear_drag", 1.0), at_cosine("quadratic_drag", sign * confusion_above * limit)), 1u);
        EXPECT_EQ(
            confusions(at_cosine("linear_drag", 1.0), at_cosine("quadratic_drag", sign * confusion_below * limit)), 0u);
    }
}

TEST(Confusion, IsOfEffectsThatPredictAComparableReduction) {
    Candidate strong = at_cosine("linear_drag", 1.0), weak = at_cosine("quadratic_drag", 1.0);
    const double limit = ConfusionPolicy{}.min_reduction * strong.score.test.explained;
    weak.score.test.explained = confusion_above * limit;
    EXPECT_EQ(confusions(strong, weak), 1u);
    weak.score.test.explained = confusion_below * limit;
    EXPECT_EQ(confusions(strong, weak), 0u);
    weak.score = at_cosine("quadratic_drag", 1.0).score;
    weak.score.failure = "the run failed";
    EXPECT_EQ(confusions(strong, weak), 0u);
}

TEST(Confusion, OfFitsNeedsAComparableWeight) {
    const double limit = ConfusionPolicy{}.comparable_weight;
    const Eigen::Vector3d same(1.0, 0.0, 0.0);
    const Candidate first = candidate("clock_offset", 0, same, 0.6);
    EXPECT_EQ(confusions(first, candidate("actuation_delay", 1, same, confusion_above * limit)), 1u);
    EXPECT_EQ(confusions(first, candidate("actuation_delay", 1, same, confusion_below * limit)), 0u);
    Candidate unfitted = candidate("actuation_delay", 1, same, 0.6);
    unfitted.judged.reset();
    EXPECT_EQ(confusions(first, unfitted), 0u);
}

/// The experiment that would separate two effects depends on what they act on.
TEST(Confusion, ProposesAnExperiment) {
    const auto proposal = [](const std::string& first, const std::string& second) {
        const JointFit declared = test::made_fit(Eigen::Vector3d::Ones(), Eigen::Vector3d::Zero());
        return find_confusions({at_cosine(first, 1.0), at_cosine(second, 1.0)}, declared, ConfusionPolicy{})
            .at(0)
            .next_experiment;
    };
    const auto has = [&](const std::string& first, const std::string& second, const std::string& words) {
        EXPECT_NE(proposal(first, second).find(words), std::string::npos) << proposal(first, second);
        EXPECT_EQ(proposal(first, second), proposal(second, first));
    };
    has("actuation_lag", "clock_offset", "slow ramp");
    has("scale_error", "soft_patch", "cameras");
    has("clamp_compliance", "soft_patch", "near the clamp");
    has("soft_patch", "quadratic_drag", "larger deflection");
    has("linear_drag", "quadratic_drag", "turned by 90 degrees");
    has("soft_patch", "stiffness_gradient", "one small and one large");
}

TEST(Confusion, GroupsAreEnteredInEveryMember) {
    const std::vector<Confusion> pairs{{"a", "b", 1.0, ""}, {"a", "c", 1.0, ""}};
    std::vector<Candidate> candidates(4);
    for (std::size_t i = 0; i < 4; ++i) candidates[i].score.id = std::string(1, "abcd"[i]);
    candidates[3].confounded_with = {"a"};  // of an earlier search
    using Ids = std::vector<std::string>;
    const std::vector<Candidate> found = with_confusions(candidates, pairs);
    EXPECT_EQ(found[0].confounded_with, (Ids{"b", "c"}));
    EXPECT_EQ(found[1].confounded_with, Ids{"a"});
    EXPECT_EQ(found[2].confounded_with, Ids{"a"});
    EXPECT_TRUE(found[3].confounded_with.empty());
}

}  // namespace
}  // namespace myo::diagnosis
