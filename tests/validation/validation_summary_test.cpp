#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "validation/validation_report.hpp"

namespace myo::test {
namespace {

/// P(X >= count) of a binomial.
double at_least(int count, int of, double p) {
    double sum = 0.0;
    for (int k = count; k <= of; ++k)
        sum += std::exp(std::lgamma(of + 1.0) - std::lgamma(k + 1.0) - std::lgamma(of - k + 1.0) + k * std::log(p) +
                        (of - k) * std::log1p(-p));
    return sum;
}

TEST(Proportion, BoundsAreThoseOfTheExactTest) {
    const validation::Proportion none{0, 60}, some{7, 50};
    EXPECT_NEAR(none.upper(), 1.0 - std::pow(0.05, 1.0 / 60.0), 1e-12);
    EXPECT_EQ(none.lower(), 0.0);
    EXPECT_NEAR(at_least(7, 50, some.lower()), 0.05, 1e-9);
    EXPECT_NEAR(1.0 - at_least(8, 50, some.upper()), 0.05, 1e-9);
    EXPECT_EQ((validation::Proportion{5, 5}).upper(), 1.0);
    EXPECT_TRUE(std::isnan(validation::Proportion{}.share()));
}

validation::CaseRecord answered(int number, validation::CaseKind kind, const std::string& truth,
                                const std::vector<std::string>& answer, double confidence) {
    validation::CaseRecord record;
    record.number = number;
    record.kind = kind;
    record.family = number % 2 == 0 ? "beam" : "tail";
    record.truth = truth;
    record.answer = answer;
    record.ranking = answer;
    record.ranking.push_back("linear_drag");
    record.confidence = confidence;
    record.level = 5.0;
    return record;
}

std::vector<validation::CaseRecord> some_records() {
    std::vector<validation::CaseRecord> records = {
        answered(0, validation::CaseKind::none, "none", {"none"}, 0.97),
        answered(1, validation::CaseKind::named, "quadratic_drag", {"quadratic_drag"}, 0.9),
        answered(2, validation::CaseKind::named, "linear_drag", {"quadratic_drag"}, 0.6),
        answered(3, validation::CaseKind::deleted, "clamp_slip", {"unknown"}, 0.8),
        answered(4, validation::CaseKind::named, "soft_patch", {"soft_patch", "scale_error"}, 0.9),
        answered(5, validation::CaseKind::named, "added_mass", {"none"}, 0.97),
        answered(6, validation::CaseKind::none, "none", {"unknown"}, 0.5),
        answered(9, validation::CaseKind::deleted, "point_mass", {"gravity_tilt"}, 0.99),
    };
    records[2].group = {"quadratic_drag"};
    records[1].errors = {{"coefficient_kg_m3", 30.0, 0.05, "quadratic_drag", true}};
    records[7].after_over_noise = 1.1;
    records.push_back(answered(10, validation::CaseKind::named, "scale_error", {}, 0.0));
    records.back().failure = "the truth does not run";
    return records;
}

TEST(ValidationSummary, CountsWhatItSays) {
    const validation::ValidationSummary s = validation::validation_summary(some_records());
    EXPECT_EQ(s.cases, 9);
    EXPECT_EQ(s.failed, 1);
    EXPECT_EQ(s.top_1.of, 4);
    EXPECT_EQ(s.top_1.count, 1);  // a second effect claimed beside the true one is wrong
    EXPECT_EQ(s.top_2.count, 3);
    EXPECT_EQ(s.separable_top_1.of, 3);
    EXPECT_EQ(s.in_group.count, 2);
    EXPECT_EQ(s.missed.count, 1);
    EXPECT_EQ(s.false_alarms.count, 1);  // "unknown" without an effect is an alarm, too
    EXPECT_EQ(s.false_alarms.of, 2);
    EXPECT_EQ(s.unknown.count, 1);
    EXPECT_EQ(s.unknown.of, 2);
    EXPECT_EQ(s.mimicked.count, 1);
    EXPECT_EQ(s.unknown_unmimicked.count, 1);
    EXPECT_EQ(s.unknown_unmimicked.of, 1);
    EXPECT_EQ(s.parameters_good.count, 1);
    EXPECT_EQ(s.confusion.at("linear_drag").at("quadratic_drag"), 1);
    EXPECT_EQ(s.confusion.at("(clamp_slip)").at("unknown"), 1);
    int binned = 0;
    for (const validation::ConfidenceBin& bin : s.reliability) binned += bin.right.of;
    EXPECT_EQ(binned, 8);
    EXPECT_EQ(s.reliability[4].right.of, 3);  // 0.97, 0.97, 0.99
    EXPECT_EQ(s.reliability[4].right.count, 1);
}

TEST(ValidationSummary, ConfidenceThatIsRightAsOftenAsItSaysHasNoError) {
    std::vector<validation::CaseRecord> records;
    for (int i = 0; i < 10; ++i)
        records.push_back(answered(i, validation::CaseKind::none, "none", {i < 8 ? "none" : "unknown"}, 0.8));
    EXPECT_NEAR(validation::validation_summary(records).calibration_error, 0.0, 1e-12);
    for (validation::CaseRecord& record : records) record.confidence = 1.0;
    EXPECT_NEAR(validation::validation_summary(records).calibration_error, 0.2, 1e-12);
}

/// A truth of 0 makes no place of a parameter: its error in another case is judged relative to that one's truth.
TEST(ValidationSummary, OnlyPositionsAreJudgedByDistance) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<validation::CaseRecord> records = {
        answered(1, validation::CaseKind::named, "point_mass", {"point_mass"}, 0.9),
        answered(2, validation::CaseKind::named, "point_mass", {"point_mass"}, 0.9)};
    records[0].errors = {{"mass_kg", 0.001, none, "point_mass", {}}, {"position_m", 0.004, none, "point_mass", {}}};
    records[1].errors = {{"mass_kg", 0.004, 0.5, "point_mass", {}}, {"position_m", 0.006, none, "point_mass", {}}};
    const validation::ValidationSummary s = validation::validation_summary(records);
    ASSERT_EQ(s.parameters.size(), 2u);
    EXPECT_EQ(s.parameters[0].parameter, "mass_kg");
    EXPECT_FALSE(s.parameters[0].is_place);
    EXPECT_DOUBLE_EQ(s.parameters[0].median, 0.5);
    EXPECT_EQ(s.parameters[0].good.count, 0);
    EXPECT_EQ(s.parameters[0].good.of, 1);
    EXPECT_TRUE(s.parameters[1].is_place);
    EXPECT_EQ(s.parameters[1].good.count, 1);
    EXPECT_EQ(s.parameters[1].good.of, 2);
}

TEST(ParameterErrors, AreRelativeToTheTruthAndPlacesAreDistances) {
    const effect::EffectDeclaration truth{
        "point_mass", {{"mass_kg", 0.01}, {"position_m", Eigen::VectorXd(Eigen::Vector3d(0.1, 0.0, 0.0))}}};
    const effect::EffectDeclaration found{
        "point_mass", {{"mass_kg", 0.012}, {"position_m", Eigen::VectorXd(Eigen::Vector3d(0.1, 0.003, 0.004))}}};
    const std::vector<validation::ParameterError> errors = validation::parameter_errors(truth, found);
    ASSERT_EQ(errors.size(), 2u);
    EXPECT_NEAR(errors[0].relative, 0.2, 1e-12);
    EXPECT_NEAR(errors[1].absolute, 0.005, 1e-12);
    EXPECT_TRUE(std::isnan(errors[1].relative));
    // A tilt the other way about the opposite axis is the same tilt.
    const auto tilt = [](double degrees, const Eigen::Vector3d& axis) {
        return effect::EffectDeclaration{"gravity_tilt", {{"tilt_deg", degrees}, {"axis", Eigen::VectorXd(axis)}}};
    };
    EXPECT_NEAR(validation::parameter_errors(tilt(4.0, {1.0, 0.0, 0.0}), tilt(-4.0, {-2.0, 0.0, 0.0})).front().relative,
                0.0, 1e-12);
}

TEST(CaseRecord, KeepsAllInItsLine) {
    for (const validation::CaseRecord& record : some_records()) {
        const Result<validation::CaseRecord> read = validation::record_from_json(validation::record_json(record));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(report::json_line(validation::record_json(*read)),
                  report::json_line(validation::record_json(record)));
    }
    EXPECT_FALSE(validation::record_from_json(report::Json::object()));
}

TEST(TrustReport, ShowsRatesMatrixAndWrongCases) {
    const std::string page = report::html(validation::validation_report(some_records(), "myoloop validate"));
    for (const char* text : {"right first", "(clamp_slip)", "soft_patch + scale_error", "case_0006",
                             "Confidence and truth", "the truth does not run"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace myo::test
