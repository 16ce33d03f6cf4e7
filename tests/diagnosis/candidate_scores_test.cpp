#include "diagnosis/screening/candidate_scores.hpp"

#include "diagnosis/screening/screen_effects.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace myo::diagnosis {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A probe that takes this share off the residual.
EffectScore score(const std::string& id, double share) {
    EffectScore made;
    made.id = id;
    made.candidate.kept = Eigen::VectorXd::Ones(1);
    made.candidate.basis = Eigen::VectorXd::Ones(1);
    made.test.explained = share;
    return made;
}

const std::vector<EffectScore> patches_and_drag{
    score("soft_patch", 0.3), score("soft_patch", 0.6),  score("soft_patch", 0.5),  score("soft_patch", 0.4),
    score("point_mass", 0.8), score("point_mass", 0.39), score("cable_tug", 0.015), score("gravity_tilt", 0.2)};

}  // namespace

/// A fit of each effect starts from the best of its probes, where that promises anything.
TEST(CandidateScores, TheBestProbeOfEachOfTheBestEffectsIsWorthAFit) {
    ASSERT_TRUE(patches_and_drag[0].usable());
    EXPECT_THAT(best_probes(patches_and_drag, 8, ScreeningPolicy{}), ElementsAre(4, 1, 7));
    EXPECT_THAT(best_probes(patches_and_drag, 2, ScreeningPolicy{}), ElementsAre(4, 1));
}

/// Then from the next best ones that promise half as much.
TEST(CandidateScores, OtherPlacesAreTheNextBestProbes) {
    EXPECT_THAT(other_places(
                    patches_and_drag, [](const std::string&) { return true; }, ScreeningPolicy{}),
                ElementsAre(2, 3));
    EXPECT_THAT(other_places(
                    patches_and_drag, [](const std::string& id) { return id != "soft_patch"; }, ScreeningPolicy{}),
                IsEmpty())
        << "0.39 is less than half of 0.8";
}

/// A probe is fitted above a least share, places down to half of the best one's, and at most so many.
TEST(CandidateScores, LimitsAreThoseOfThePolicy) {
    ScreeningPolicy policy;
    policy.min_explained = 0.199;
    EXPECT_THAT(best_probes(patches_and_drag, 8, policy), ElementsAre(4, 1, 7));
    policy.min_explained = 0.201;
    EXPECT_THAT(best_probes(patches_and_drag, 8, policy), ElementsAre(4, 1));
    const auto all = [](const std::string&) { return true; };
    policy = {};
    policy.comparable_place = 0.3 / 0.6 + 1e-9;
    EXPECT_THAT(other_places(patches_and_drag, all, policy), ElementsAre(2, 3));
    policy.comparable_place = 0.39 / 0.8 - 1e-9;
    policy.max_places = 9;
    EXPECT_THAT(other_places(patches_and_drag, all, policy), ElementsAre(2, 3, 5, 0));
    policy.max_places_of_all = 3;
    EXPECT_THAT(other_places(patches_and_drag, all, policy), ElementsAre(2, 3, 5));
}

TEST(CandidateScores, TheBestScoreLeavesTheLeast) {
    std::vector<EffectScore> scores = patches_and_drag;
    for (EffectScore& made : scores) made.left = 100.0 * (1.0 - made.test.explained);
    EXPECT_EQ(best_score(scores).id, "point_mass");
    EXPECT_EQ(best_score({}).id, "");
    EXPECT_TRUE(std::isinf(best_score({}).left));
}

/// Each effect once, by its best probe; p-values count all probes (Holm): the k-th smallest of n is multiplied by
/// n + 1 - k.
TEST(CandidateScores, ListedCandidatesHaveAdjustedPValues) {
    std::vector<EffectScore> scores{score("soft_patch", 0.3), score("soft_patch", 0.6), score("point_mass", 0.5),
                                    score("cable_tug", 0.4)};
    const double p[] = {0.04, 0.001, 0.01, 0.3};
    for (std::size_t i = 0; i < 4; ++i) scores[i].test.p = p[i];
    scores[3].failure = "the run failed";
    const std::vector<Candidate> listed = listed_candidates(scores);
    ASSERT_EQ(listed.size(), 3u);
    EXPECT_EQ(listed[0].score.id, "cable_tug");
    EXPECT_EQ(listed[0].adjusted_p, 1.0);
    EXPECT_EQ(listed[1].score.id, "point_mass");
    EXPECT_NEAR(listed[1].adjusted_p, 3.0 * 0.01, 1e-12);
    EXPECT_EQ(listed[2].score.id, "soft_patch");
    EXPECT_EQ(listed[2].score.share(), 0.6);
    EXPECT_NEAR(listed[2].adjusted_p, 4.0 * 0.001, 1e-12);
    for (const Candidate& candidate : listed) EXPECT_FALSE(candidate.judged);
}

}  // namespace myo::diagnosis
