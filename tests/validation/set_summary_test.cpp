#include "validation/set_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "effect/catalogue.hpp"
#include "validation/case_with.hpp"
#include "validation/synthetic_effects.hpp"
#include "validation/validation_summary.hpp"

namespace myo::validation::set_summary_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SetsOfEffects, AreRightInAnyOrderAndOnlyWhole) {
    EXPECT_THAT(case_with(CaseKind::named, "drag + tilt", {}).members(), ElementsAre("drag", "tilt"));
    EXPECT_THAT(case_with(CaseKind::none, "none", {}).members(), IsEmpty());
    EXPECT_TRUE(case_with(CaseKind::named, "drag + tilt", {"tilt", "drag"}).right());
    EXPECT_FALSE(case_with(CaseKind::named, "drag + tilt", {"tilt"}).right());
    EXPECT_FALSE(case_with(CaseKind::named, "drag + tilt", {"tilt", "drag", "slip"}).right());
    CaseRecord mimicked = case_with(CaseKind::named, "drag + tilt", {"damping", "tilt"});
    EXPECT_FALSE(mimicked.right_or_grouped());
    mimicked.group = {"damping"};
    EXPECT_TRUE(mimicked.right_or_grouped());
    mimicked.answer = {"tilt"};
    EXPECT_FALSE(mimicked.right_or_grouped()) << "one is missing";
}

/// Counted by hand over five cases; the deleted effect and the failed case count nowhere.
TEST(SetsOfEffects, AreCountedByTheirMembers) {
    std::vector<CaseRecord> records = {
        case_with(CaseKind::none, "none", {"none"}),
        case_with(CaseKind::named, "drag", {"drag", "slip"}),
        case_with(CaseKind::named, "drag + tilt", {"tilt", "drag"}),
        case_with(CaseKind::named, "drag + tilt", {"tilt"}),
        case_with(CaseKind::named, "drag + slip + tilt", {"unknown"}),
        case_with(CaseKind::deleted, "drag", {"slip"}),
        case_with(CaseKind::named, "drag + tilt", {"slip"}),
    };
    records.back().failure = "the truth does not run";
    records[2].errors = {{"coefficient", 1.0, 0.1, "drag", true}, {"axis", 1.0, 0.1, "tilt", {}}};
    records[3].errors = {{"tilt_deg", 1.0, 0.1, "tilt", false}};
    const SetSummary s = set_summary(records);
    ASSERT_EQ(s.exact.size(), 4u);
    EXPECT_EQ(s.exact.at(0).share(), 1.0);
    EXPECT_EQ(s.exact.at(1).share(), 0.0);
    EXPECT_EQ(s.exact.at(2).share(), 0.5);
    EXPECT_EQ(s.exact.at(3).share(), 0.0);
    EXPECT_EQ(s.precision.count, 4);
    EXPECT_EQ(s.precision.of, 5);
    EXPECT_EQ(s.recall.count, 4);
    EXPECT_EQ(s.recall.of, 8);
    EXPECT_EQ(s.false_inclusion.count, 1);
    EXPECT_EQ(s.false_inclusion.of, 5);
    EXPECT_EQ(s.covered.count, 1);
    EXPECT_EQ(s.covered.of, 2);
    EXPECT_NE(set_summary_text(s).find("does not act: 1 of 5, 20.0 % (at most"), std::string::npos);
    EXPECT_EQ(validation_summary(records).top_1.of, 1) << "rates of single effects count no sets";
}

/// Twenty probabilities of 0.2, of which four act, are calibrated; of which none acts, they are wrong by 0.2.
TEST(SetsOfEffects, ProbabilitiesAreComparedWithWhatActs) {
    for (const int acting : {4, 0}) {
        std::vector<CaseRecord> records;
        for (int k = 0; k < 20; ++k) {
            records.push_back(case_with(CaseKind::named, k % 5 == 0 && acting > 0 ? "slip + tilt" : "tilt", {"tilt"}));
            records.back().probabilities = {{"slip", 0.2}, {"tilt", 0.99}, {"drag", 0.01}};
        }
        const SetSummary s = set_summary(records);
        EXPECT_EQ(s.open_probabilities, 20);
        EXPECT_NEAR(s.probability_error, acting > 0 ? 0.0 : 0.2, 1e-12);
    }
    EXPECT_TRUE(std::isnan(set_summary({}).probability_error));
}

TEST(SetsOfEffects, AreKeptByARecord) {
    CaseRecord record = case_with(CaseKind::named, "drag + tilt", {"tilt", "drag"});
    record.probabilities = {{"drag", 0.7}};
    record.errors = {{"coefficient", 1.0, 0.1, "drag", true}, {"tilt_deg", 1.0, 0.1, "tilt", {}}};
    const Result<CaseRecord> read = record_from_json(record_json(record));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->right());
    EXPECT_EQ(read->probabilities, record.probabilities);
    ASSERT_EQ(read->errors.size(), 2u);
    EXPECT_EQ(read->errors[0].effect, "drag");
    EXPECT_EQ(read->errors[0].covered, std::optional(true));
    EXPECT_EQ(read->errors[1].covered, std::nullopt);
}

TEST(SetsOfEffects, AreDrawnForOneBody) {
    for (const int together : {2, 4}) {
        const CaseChoice choice{.seed = 3, .families = {}, .effects = {}, .together = together};
        std::size_t whole = 0, named = 0;
        for (int k = 0; k < 60; ++k) {
            const SyntheticCase c = drawn_case(choice, k);
            if (c.kind != CaseKind::named) {
                EXPECT_EQ(c.effects.size(), c.kind == CaseKind::none ? 0u : 1u) << k;
                continue;
            }
            ++named;
            whole += c.effects.size() == static_cast<std::size_t>(together) ? 1 : 0;
            EXPECT_EQ(c.wanted_levels.size(), c.effects.size()) << k;
            EXPECT_EQ(c.effects.front().id,
                      drawn_case({.seed = 3, .families = {}, .effects = {}}, k).effects.front().id)
                << "the first cycles through the catalogue";
            int shortened = 0;
            std::map<std::string, int> ids;
            for (const effect::EffectDeclaration& effect : c.effects) {
                ++ids[effect.id];
                shortened += effect::find_effect(effect.id)->clamp_shortening.empty() ? 0 : 1;
                const effect::EffectNeeds& needs = effect_draw(effect.id).needs;
                EXPECT_TRUE(!needs.muscles || !c.muscles.empty()) << k << " " << effect.id;
                EXPECT_TRUE(!needs.tendon || c.tendon) << k << " " << effect.id;
                EXPECT_TRUE(!needs.deep_clamp || c.body.held_m > 0.0) << k << " " << effect.id;
                EXPECT_TRUE(!needs.known_damping || c.material.damping_is_known) << k << " " << effect.id;
            }
            EXPECT_EQ(ids.size(), c.effects.size()) << "each acts once";
            EXPECT_LE(shortened, 1) << k;
        }
        EXPECT_GT(whole, 9 * named / 10);
    }
}

TEST(SetsOfEffects, AreRefusedBeyondWhatADiagnosisNames) {
    EXPECT_TRUE(check_choice({.seed = 1, .families = {}, .effects = {}, .together = 4}));
    const Result<void> many = check_choice({.seed = 1, .families = {}, .effects = {}, .together = 5});
    ASSERT_FALSE(many);
    EXPECT_EQ(many.error().where, "--together");
    const Result<void> few = check_choice({.seed = 1, .families = {}, .effects = {"quadratic_drag"}, .together = 2});
    ASSERT_FALSE(few);
    EXPECT_EQ(few.error().what, "2 effects cannot be drawn from 1");
}

}  // namespace
}  // namespace myo::validation::set_summary_test
