#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "effect/effect.hpp"
#include "validation/case_record.hpp"
#include "validation/case_with.hpp"
#include "validation/defaults_record.hpp"
#include "validation/defaults_summary.hpp"
#include "validation/finite_median.hpp"
#include "validation/proportion.hpp"
#include "validation/validation_summary.hpp"

// When an answer counts as right, at and beside every limit.

namespace myo::validation::judgement_test {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

const double not_known = std::numeric_limits<double>::quiet_NaN();

TEST(Judgement, OneAnswerAloneIsRight) {
    EXPECT_TRUE(case_with(CaseKind::named, "tilt", {"tilt"}).right());
    EXPECT_TRUE(case_with(CaseKind::none, "none", {"none"}).right());
    EXPECT_TRUE(case_with(CaseKind::deleted, "tilt", {"unknown"}).right());
    EXPECT_FALSE(case_with(CaseKind::deleted, "tilt", {"tilt"}).right());
    EXPECT_FALSE(case_with(CaseKind::named, "tilt", {"unknown"}).right());
    EXPECT_FALSE(case_with(CaseKind::named, "tilt", {"tilt", "drag"}).right());
    EXPECT_FALSE(case_with(CaseKind::named, "tilt", {}).right());
    CaseRecord failed = case_with(CaseKind::named, "tilt", {"tilt"});
    failed.ranking = failed.group = {"tilt"};
    failed.failure = "cancelled";
    EXPECT_FALSE(failed.right() || failed.right_within(1) || failed.right_or_grouped());
}

TEST(Judgement, PlacesOfARankingAreCountedFromTheFirst) {
    CaseRecord record = case_with(CaseKind::named, "tilt", {"drag"});
    record.ranking = {"drag", "slip", "tilt"};
    EXPECT_FALSE(record.right_within(0));
    EXPECT_FALSE(record.right_within(2));
    EXPECT_TRUE(record.right_within(3));
    EXPECT_TRUE(record.right_within(50));
    record.kind = CaseKind::deleted;
    EXPECT_FALSE(record.right_within(50));
    record.ranking.push_back("unknown");
    EXPECT_TRUE(record.right_within(4));
    record.ranking.clear();
    EXPECT_FALSE(record.right_within(5));
}

TEST(Judgement, AnEffectOfTheGroupCountsOnlyAlone) {
    CaseRecord record = case_with(CaseKind::named, "tilt", {"drag"});
    EXPECT_FALSE(record.grouped() || record.right_or_grouped());
    record.group = {"slip", "drag"};
    EXPECT_TRUE(record.grouped() && record.right_or_grouped());
    EXPECT_FALSE(record.right());
    record.answer = {"drag", "slip"};
    EXPECT_FALSE(record.right_or_grouped());
    record.answer = {"tilt"};
    EXPECT_TRUE(record.right_or_grouped());
}

TEST(Judgement, ErrorsOfParametersNeedEqualNamesAndLengths) {
    const auto vector = [](std::initializer_list<double> values) {
        return Eigen::VectorXd(Eigen::VectorXd::Map(values.begin(), static_cast<Eigen::Index>(values.size())));
    };
    const effect::EffectDeclaration truth{"no_such_effect",
                                          {{"anchor_m", 0.1},
                                           {"axis", vector({1, 0, 0})},
                                           {"course", vector({3, 4})},
                                           {"length", vector({1, 2})},
                                           {"marker", std::string("tip")},
                                           {"only_true", 1.0},
                                           {"zero", 0.0}}};
    const effect::EffectDeclaration found{"no_such_effect",
                                          {{"anchor_m", 0.3},
                                           {"axis", vector({0, 1, 0})},
                                           {"course", vector({3, 3})},
                                           {"length", vector({1, 2, 3})},
                                           {"marker", std::string("tip")},
                                           {"only_found", 1.0},
                                           {"zero", 2.0}}};
    const std::vector<ParameterError> errors = parameter_errors(truth, found);
    ASSERT_EQ(errors.size(), 3u);
    EXPECT_EQ(errors[0].name, "anchor_m");
    EXPECT_NEAR(errors[0].absolute, 0.2, 1e-15);
    EXPECT_TRUE(std::isnan(errors[0].relative));
    EXPECT_EQ(errors[1].name, "course");
    EXPECT_DOUBLE_EQ(errors[1].absolute, 1.0);
    EXPECT_DOUBLE_EQ(errors[1].relative, 0.2);
    EXPECT_EQ(errors[2].name, "zero");
    EXPECT_EQ(errors[2].absolute, 2.0);
    EXPECT_TRUE(std::isnan(errors[2].relative));
}

/// 2 % of the truth and three deviations, of either sign.
TEST(Judgement, ANumberIsRightUpToItsTolerance) {
    for (const double truth : {1000.0, -1000.0})
        for (const double sign : {1.0, -1.0}) {
            EXPECT_TRUE(is_right({"x", truth, truth + sign * 19.9, 0.0}));
            EXPECT_FALSE(is_right({"x", truth, truth + sign * 20.1, 0.0}));
            EXPECT_TRUE(is_right({"x", truth, truth + sign * 49.9, 10.0}));
            EXPECT_FALSE(is_right({"x", truth, truth + sign * 50.1, 10.0}));
        }
    EXPECT_FALSE(is_right({"x", 1000.0, not_known, 10.0}));
    EXPECT_TRUE(is_right({"x", 1000.0, 1000.0, std::numeric_limits<double>::infinity()}));
    EXPECT_FALSE(is_right({"x", 1000.0, 1100.0, std::numeric_limits<double>::infinity()}));
    const FittedNumber number{"x", 200.0, 190.0, 4.0};
    EXPECT_NEAR(number.error(), -0.05, 1e-15);
    EXPECT_DOUBLE_EQ(number.normalised(), -2.5);
}

DefaultsRecord fitted(double value, const std::vector<std::string>& checks, const std::string& slip = {}) {
    DefaultsRecord record;
    record.shape = "bar";
    record.slip = slip;
    record.truth_dofs = 100;
    record.numbers = {{"youngs_modulus_Pa", 1000.0, value, 1.0}};
    for (const std::string& check : checks) record.remarks.push_back({check, "", "", false});
    return record;
}

TEST(Judgement, AFailureIsNoAnswerUnlessItsCauseIsNamed) {
    DefaultsRecord failed = fitted(1500.0, {});
    failed.failure = "the fit does not run";
    EXPECT_EQ(judged(failed), DefaultsAnswer::failed);
    failed.remarks = {{"mesh", "", "", true}};
    EXPECT_EQ(judged(failed), DefaultsAnswer::cause_named);
    DefaultsRecord nothing = fitted(0.0, {"residual"});
    nothing.numbers.clear();
    EXPECT_EQ(judged(nothing), DefaultsAnswer::failed);
    // Right numbers outweigh what is said of them; a slip changes which checks name the cause.
    EXPECT_EQ(judged(fitted(1000.0, {"residual"}, "modulus_in_MPa")), DefaultsAnswer::right);
    EXPECT_EQ(judged(fitted(1500.0, {"mesh"}, "modulus_in_MPa")), DefaultsAnswer::other_warning);
    EXPECT_EQ(judged(fitted(1500.0, {"units"}, "modulus_in_MPa")), DefaultsAnswer::cause_named);
}

TEST(Judgement, ARefusalMustNameItsCause) {
    DefaultsRecord refused = fitted(1000.0, {});
    refused.refusal = "material.density_kg_m3: too light";
    EXPECT_EQ(judged(refused), DefaultsAnswer::other_warning);
    EXPECT_TRUE(is_false_alarm(refused));
    refused.slip = "density_in_g_cm3";
    EXPECT_EQ(judged(refused), DefaultsAnswer::cause_named);
    EXPECT_FALSE(is_false_alarm(refused));
    // A slip that no message may refuse is not named by one.
    refused.slip = "fit_trial_predicted";
    EXPECT_EQ(judged(refused), DefaultsAnswer::other_warning);
}

TEST(Judgement, AlarmsAreFalseOnlyForRightNumbersOfACorrectDeclaration) {
    EXPECT_FALSE(is_false_alarm(fitted(1000.0, {})));
    EXPECT_TRUE(is_false_alarm(fitted(1000.0, {"residual"})));
    EXPECT_FALSE(is_false_alarm(fitted(1500.0, {"residual"})));
    EXPECT_FALSE(is_false_alarm(fitted(1000.0, {"residual"}, "modulus_in_MPa")));
    EXPECT_TRUE(is_false_alarm(fitted(1000.0, {"influence"})));
    DefaultsRecord undetermined = fitted(1500.0, {"influence"});
    undetermined.numbers[0].deviation = not_known;
    EXPECT_FALSE(is_false_alarm(undetermined));
    undetermined.remarks.push_back({"mesh", "", "", false});
    EXPECT_TRUE(is_false_alarm(undetermined));
}

TEST(Judgement, CasesWithoutATruthAreLeftOutOfTheRates) {
    DefaultsRecord unmade = fitted(0.0, {}), without_fit = fitted(0.0, {}, "held_on_a_line");
    for (DefaultsRecord* const record : {&unmade, &without_fit}) record->failure = "no", record->numbers.clear();
    unmade.truth_dofs = 0;
    const DefaultsSummary s = defaults_summary({unmade, without_fit, fitted(1000.0, {})});
    EXPECT_EQ(s.cases, 3);
    EXPECT_EQ(s.answers.at(DefaultsAnswer::failed), 2);
    EXPECT_EQ(s.right.of, 2);
    EXPECT_EQ(s.by_slip.at("held_on_a_line").of, 1);
    EXPECT_EQ(s.by_slip.at("none").count, 1);
    EXPECT_EQ(s.by_shape.at("bar").of, 2);
    EXPECT_EQ(s.false_alarms.of, 1);
    EXPECT_TRUE(std::isnan(s.longest_fit_s));
    EXPECT_TRUE(std::isnan(s.median_time_ratio));
    EXPECT_TRUE(defaults_summary({}).answers.empty());
    EXPECT_EQ(summary_json(s).at("by_slip").at("none").at("of"), 1);
    EXPECT_EQ(summary_json(s).at("answers").at("failed"), 2);
    EXPECT_TRUE(summary_json(s).at("median_time_ratio").is_null());
}

/// Bins include their lower edge, and the last one also 1.
TEST(Judgement, ConfidencesFallIntoTheBinThatBeginsWithThem) {
    std::vector<CaseRecord> records;
    for (const double confidence : {0.0, 0.4999, 0.5, 0.7, 0.8499, 0.85, 0.95, 1.0, not_known}) {
        records.push_back(case_with(CaseKind::none, "none", {"none"}));
        records.back().confidence = confidence;
    }
    std::vector<int> counts;
    for (const ConfidenceBin& bin : validation_summary(records).reliability) counts.push_back(bin.right.of);
    EXPECT_THAT(counts, ElementsAre(2, 1, 2, 1, 2));
    const ValidationSummary empty = validation_summary({});
    EXPECT_TRUE(std::isnan(empty.calibration_error));
    EXPECT_TRUE(std::isnan(empty.reliability.front().mean));
    EXPECT_TRUE(std::isnan(empty.longest_diagnose_s));
}

TEST(Judgement, WordsNameCountShareAndTheBoundThatMatters) {
    const Proportion some{9, 12}, none{};
    EXPECT_THAT(at_least_words(some), StartsWith("9 of 12, 75.0 % (at least "));
    EXPECT_THAT(at_most_words(some), StartsWith("9 of 12, 75.0 % (at most "));
    EXPECT_EQ(at_least_words(none), "none of none");
    EXPECT_EQ(at_most_words(none), "none of none");
    const report::Json json = proportion_json(some);
    EXPECT_EQ(json.at("share"), 0.75);
    EXPECT_LT(json.at("lower_95").get<double>(), 0.75);
    EXPECT_GT(json.at("upper_95").get<double>(), 0.75);
    EXPECT_TRUE(proportion_json(none).at("share").is_null());
    // Counting misses instead of hits mirrors the bounds, and more confidence widens them.
    const Proportion misses{3, 12};
    EXPECT_NEAR(some.lower(), 1.0 - misses.upper(), 1e-9);
    EXPECT_LT(some.lower(0.99), some.lower(0.9));
    EXPECT_GT(some.upper(0.99), some.upper(0.9));
    EXPECT_TRUE(none.lower() == 0.0 && none.upper() == 1.0);
}

TEST(Judgement, MediansPassOverWhatIsNotFinite) {
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(finite_median({3.0, not_known, 1.0, -infinite, 2.0}), 2.0);
    EXPECT_EQ(finite_median({4.0, infinite, 1.0}), 2.5);
    EXPECT_EQ(finite_median({7.0}), 7.0);
    EXPECT_TRUE(std::isnan(finite_median({})));
    EXPECT_TRUE(std::isnan(finite_median({not_known, infinite})));
}

}  // namespace
}  // namespace myo::validation::judgement_test
