#include "diagnosis/screening/candidate_scores.hpp"

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
    EXPECT_THAT(best_probes(patches_and_drag, 8), ElementsAre(4, 1, 7));
    EXPECT_THAT(best_probes(patches_and_drag, 2), ElementsAre(4, 1));
}

/// Then from the next best ones that promise half as much.
TEST(CandidateScores, OtherPlacesAreTheNextBestProbes) {
    EXPECT_THAT(other_places(patches_and_drag, [](const std::string&) { return true; }), ElementsAre(2, 3));
    EXPECT_THAT(other_places(patches_and_drag, [](const std::string& id) { return id != "soft_patch"; }), IsEmpty())
        << "0.39 is less than half of 0.8";
}

}  // namespace myo::diagnosis
