#include "diagnosis/screening/confusion.hpp"

#include <gtest/gtest.h>

namespace myo::diagnosis {
namespace {

/// An effect foretold to go along one axis of three, and a fit that has it take these off a residual of ones.
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
    d.candidates = candidates;
    find_confusions(d);
    return d;
}

TEST(Confusion, IsWhatIsForetoldAlike) {
    const Diagnosis d = of({candidate("clock_offset", 0, {1.0, 0.0, 0.0}, 0.9),
                            candidate("actuation_lag", 0, {0.0, 1.0, 0.0}, 0.0),
                            candidate("added_mass", 1, {0.0, 1.0, 0.0}, 0.0)});
    ASSERT_EQ(d.confusions.size(), 1u);
    EXPECT_EQ(d.confusions[0].first, "clock_offset");
    EXPECT_EQ(d.confusions[0].second, "actuation_lag");
    EXPECT_EQ(d.candidates[1].like, (std::vector<std::string>{"clock_offset"}));
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

}  // namespace
}  // namespace myo::diagnosis
