#include "diagnosis/verdict/twins.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/made_fits.hpp"
#include "diagnosis/verdict/probabilities.hpp"

namespace myo::diagnosis::twins_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

/// A fit whose effects take this change from the declared residual.
JudgedFit fit_with(const std::vector<std::string>& ids, const Eigen::VectorXd& change, double weight) {
    JudgedFit fit = fit_that_leaves(0.3);
    fit.fit.residual = Eigen::VectorXd::Constant(100, 10.0) - change;
    for (const std::string& id : ids) fit.fit.effects.push_back({id, {}});
    fit.weight = weight;
    return fit;
}

Candidate candidate_with(const std::string& id, const Eigen::VectorXd& change, double weight) {
    Candidate candidate;
    candidate.score.id = id;
    candidate.judged = fit_with({id}, change, weight);
    return candidate;
}

/// Changes by the effects: "late" and "clock" move alike but for a constant, which a declared parameter compensates;
/// "drag" moves otherwise.
struct Made {
    Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(100, 0.0, 10.0), wave = ramp.array().sin() * 5.0;
    Diagnosis d = with_candidate(0.3);

    Made() {
        d.declared.fit.jacobian = Eigen::MatrixXd::Ones(100, 1);
        d.candidates = {candidate_with("late", ramp, 0.9), candidate_with("drag", wave, 0.0),
                        candidate_with("clock", (1.02 * ramp).array() + 3.0, 0.1)};
        d.verdict.kind = VerdictKind::effects;
        d.verdict.effects = d.candidates[0].judged->fit.effects;
        d.verdict.trust = 0.93;
        d.verdict.confidence = 0.93 * 0.9;
        d.verdict.ranking = {"late", "drag", "clock", "unknown", "none"};
    }
};

TEST(Twins, MoveAlikeUpToWhatDeclaredParametersCompensate) {
    Made made;
    EXPECT_THAT(twins_of(made.d, "late"), ElementsAre("clock"));
    made.d.declared.fit.jacobian.resize(100, 0);
    EXPECT_THAT(twins_of(made.d, "late"), IsEmpty()) << "nothing compensates the constant";
}

/// Far from the declared model all that come near move nearly alike.
TEST(Twins, LeaveAboutAsMuch) {
    Made made;
    const Eigen::VectorXd far = 100.0 * made.ramp, left = made.wave;
    const auto clock_leaves = [&](double factor) {
        made.d.declared.fit.residual = far;
        made.d.candidates[0].judged->fit.residual = left;
        made.d.candidates[2].judged->fit.residual = factor * left;
        return twins_of(made.d, "late");
    };
    EXPECT_THAT(clock_leaves(1.1), ElementsAre("clock"));
    EXPECT_THAT(clock_leaves(1.5), IsEmpty());
}

/// Whatever the fits say, each has half.
TEST(Twins, ShareTheirProbability) {
    const Made made;
    const Diagnosis d = with_twins(made.d);
    ASSERT_EQ(d.verdict.twins.size(), 1u);
    EXPECT_THAT(d.verdict.twins[0], ElementsAre("late", "clock"));
    EXPECT_THAT(d.verdict.ranking, ElementsAre("late", "clock", "drag", "unknown", "none"));
    EXPECT_NEAR(d.verdict.confidence, 0.93 / 2.0, 1e-12);
    const std::map<std::string, double> p = effect_probabilities(d);
    EXPECT_DOUBLE_EQ(p.at("late"), p.at("clock"));
    EXPECT_LE(p.at("late"), 0.93 / 2.0 + 1e-12);
    EXPECT_GT(p.at("late") + p.at("clock"), 0.5);
}

/// In a set the member is exchanged, beside the same others.
TEST(Twins, AreFoundWithinASet) {
    Made made;
    Diagnosis& d = made.d;
    d.sets = {fit_with({"late", "drag"}, made.ramp + made.wave, 0.9),
              fit_with({"drag", "clock"}, 1.01 * made.ramp + made.wave, 0.1)};
    d.verdict.effects = d.sets[0].fit.effects;
    EXPECT_THAT(twins_of(d, "late"), ElementsAre("clock"));
    EXPECT_THAT(twins_of(d, "drag"), IsEmpty());
    EXPECT_THAT(with_twins(d).verdict.twins, ElementsAre(ElementsAre("late", "clock")));
}

TEST(Twins, ConcernNamedEffectsOnly) {
    Made made;
    made.d.verdict.kind = VerdictKind::unknown;
    EXPECT_THAT(with_twins(made.d).verdict.twins, IsEmpty());
}

}  // namespace
}  // namespace myo::diagnosis::twins_test
