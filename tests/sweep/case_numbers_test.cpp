#include "sweep/case_numbers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/folder.hpp"

// Numbers that a table takes from the report of a command, and what becomes of those that it lacks.

namespace myo::sweep::case_numbers_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Numbers of a report with this text.
Result<CaseNumbers> numbers_in(CaseCommand command, const std::string& text) {
    const test::Folder folder("numbers_of_a_report");
    folder.write(report_of(command, "").string(), text);
    return read_case_numbers(command, folder.path());
}

std::vector<std::string> names_in(const CaseNumbers& read) {
    std::vector<std::string> names;
    for (const CaseNumber& number : read.numbers) names.push_back(number.name);
    return names;
}

const CaseNumber& named(const CaseNumbers& read, const std::string& name) {
    static const CaseNumber none;
    for (const CaseNumber& number : read.numbers)
        if (number.name == name) return number;
    ADD_FAILURE() << "there is no number " << name;
    return none;
}

TEST(NumbersOfAReport, EveryCommandHasItsFile) {
    const std::filesystem::path folder = "out/cases/0001";
    EXPECT_EQ(report_of(CaseCommand::simulate, folder), folder / "simulate.json");
    EXPECT_EQ(report_of(CaseCommand::calibrate, folder), folder / "calibrate.json");
    EXPECT_EQ(report_of(CaseCommand::diagnose, folder), folder / "report.json");
    EXPECT_EQ(report_of(CaseCommand::optimize, folder), folder / "optimize.json");
}

TEST(NumbersOfAReport, ASimulationHasErrorsShownAndTheRestInFilesOnly) {
    const Result<CaseNumbers> read = numbers_in(CaseCommand::simulate, R"({"steps": 40, "dofs": 135, "trials": [
        {"name": "drop", "rms_m": 0.002, "mean_distance_m": 0.0015,
         "markers": {"tip": {"steady_state_m": [0.04, null, 0.018]}, "middle": {"steady_state_m": [0.02, 0.01]}}},
        {"name": "pull", "rms_m": null, "markers": {"tip": {}}}]})");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->verdict, "");
    // A null is no number, and neither is a place that was not reached.
    EXPECT_THAT(names_in(*read),
                ElementsAre("rms of drop", "mean distance of drop", "tip x at rest in drop", "tip z at rest in drop",
                            "middle x at rest in drop", "middle y at rest in drop", "steps", "degrees of freedom"));
    EXPECT_TRUE(named(*read, "rms of drop").shown);
    for (const char* hidden : {"mean distance of drop", "tip z at rest in drop", "steps", "degrees of freedom"})
        EXPECT_FALSE(named(*read, hidden).shown) << hidden;
    EXPECT_EQ(named(*read, "rms of drop").value, 0.002);
    EXPECT_EQ(named(*read, "tip z at rest in drop").value, 0.018);
    EXPECT_EQ(named(*read, "middle y at rest in drop").value, 0.01);
    EXPECT_EQ(named(*read, "tip z at rest in drop").unit, "m");
    EXPECT_EQ(named(*read, "degrees of freedom").unit, "");
    for (const CaseNumber& number : read->numbers) EXPECT_TRUE(std::isnan(number.deviation)) << number.name;
}

TEST(NumbersOfAReport, ACalibrationHasItsValuesFirstAndWhetherItConverged) {
    const std::string numbers = R"("parameters": {"youngs_modulus_Pa": {"value": 2e5, "std": 3e3, "unit": "Pa"},
        "damping_s": {"value": 0.004, "std": null, "unit": "s"}, "unknown": {"value": null, "std": 1, "unit": ""}},
        "rms_before_m": 0.009, "rms_after_m": 0.001, "validation_rms_before_m": 0.008, "validation_rms_after_m": 0.003,
        "evaluations": 17, "dofs": 300, "trials": [{"name": "drop", "rms_m": 5, "rms_after_m": 0.0012}]})";
    const Result<CaseNumbers> read = numbers_in(CaseCommand::calibrate, R"({"converged": true, )" + numbers);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->verdict, "converged");
    EXPECT_THAT(names_in(*read),
                ElementsAre("youngs_modulus_Pa", "damping_s", "rms of the fit", "rms of the validation trials",
                            "rms of drop", "rms before the fit", "evaluations", "degrees of freedom"));
    EXPECT_EQ(named(*read, "youngs_modulus_Pa").value, 2e5);
    EXPECT_EQ(named(*read, "youngs_modulus_Pa").deviation, 3e3);
    EXPECT_EQ(named(*read, "youngs_modulus_Pa").unit, "Pa");
    EXPECT_TRUE(std::isnan(named(*read, "damping_s").deviation));
    // The errors are those after the fit; that of a single trial stands in the files only.
    EXPECT_EQ(named(*read, "rms of the fit").value, 0.001);
    EXPECT_EQ(named(*read, "rms of the validation trials").value, 0.003);
    EXPECT_EQ(named(*read, "rms of drop").value, 0.0012);
    EXPECT_EQ(named(*read, "rms before the fit").value, 0.009);
    EXPECT_TRUE(named(*read, "rms of the fit").shown);
    EXPECT_FALSE(named(*read, "rms of drop").shown);
    EXPECT_FALSE(named(*read, "evaluations").shown);
    for (const char* other : {R"({"converged": false, )", R"({"converged": null, )", R"({"converged": "true", )", "{"})
        EXPECT_EQ(numbers_in(CaseCommand::calibrate, other + numbers)->verdict, "not converged") << other;
}

TEST(NumbersOfAReport, ADiagnosisTakesEveryErrorFromItsOwnPlace) {
    const Result<CaseNumbers> read = numbers_in(CaseCommand::diagnose, R"({"verdict": {"effects": [], "confidence": 1},
        "declared_fit": {"rms_m": 1}, "augmented_fit": {"rms_m": 2, "parameters": {"damping_s": 0.5, "law": "x"}},
        "validation": {"before_rms_m": 3, "after_rms_m": 4},
        "trials": [{"name": "drop", "rms_m": 9, "after_rms_m": 5}]})");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->verdict, "");
    EXPECT_EQ(named(*read, "rms of the declared fit").value, 1.0);
    EXPECT_EQ(named(*read, "rms of the fit").value, 2.0);
    EXPECT_EQ(named(*read, "rms of the validation trials before").value, 3.0);
    EXPECT_EQ(named(*read, "rms of the validation trials").value, 4.0);
    EXPECT_EQ(named(*read, "rms of drop").value, 5.0);
    EXPECT_EQ(named(*read, "damping_s").value, 0.5);
    EXPECT_FALSE(named(*read, "damping_s").shown);
    EXPECT_THAT(names_in(*read), testing::Not(testing::Contains("law")));
}

TEST(NumbersOfAReport, ComponentsOfAVectorOfAnEffectAreHiddenAndWordsLeftOut) {
    const Result<CaseNumbers> read = numbers_in(CaseCommand::diagnose, R"({"verdict": {"effects": [{"id": "force",
        "parameters": {"newtons": 2.5, "place_m": [0.1, "x", 0.3], "marker": "tip"}}]}})");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->verdict, "force");
    EXPECT_THAT(names_in(*read), ElementsAre("force.newtons", "force.place_m[0]", "force.place_m[2]"));
    EXPECT_TRUE(named(*read, "force.newtons").shown);
    EXPECT_FALSE(named(*read, "force.place_m[2]").shown);
    EXPECT_EQ(named(*read, "force.place_m[2]").value, 0.3);
}

TEST(NumbersOfAReport, ASearchShowsHeldSignalsWithTheDeviationsThatItKnows) {
    const Result<CaseNumbers> read = numbers_in(CaseCommand::optimize, R"({"reached": true, "rms_before_m": 0.4,
        "rms_after_m": 0.1, "noise_levels": 3, "evaluations": 5, "signals": [
        {"name": "a", "unit": "Pa", "values": [7], "std": [null]}, {"name": "b", "unit": "Pa", "values": [8]},
        {"name": "c", "unit": "Pa", "values": [null], "std": [1]}, {"name": "d", "unit": "Pa", "values": []},
        {"name": "e", "unit": "Pa", "values": [9], "std": [0.5]}]})");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->verdict, "reached");
    EXPECT_THAT(names_in(*read), ElementsAre("rms of the target", "remaining distance", "a", "b", "e",
                                             "rms before the search", "evaluations"));
    EXPECT_TRUE(std::isnan(named(*read, "a").deviation));
    EXPECT_TRUE(std::isnan(named(*read, "b").deviation));
    EXPECT_EQ(named(*read, "e").deviation, 0.5);
    EXPECT_EQ(named(*read, "e").unit, "Pa");
    EXPECT_EQ(named(*read, "remaining distance").unit, "noise levels");
    EXPECT_EQ(named(*read, "rms of the target").value, 0.1);
    EXPECT_EQ(named(*read, "rms before the search").value, 0.4);
}

TEST(NumbersOfAReport, AnEmptyReportHasNone) {
    for (const CaseCommand command :
         {CaseCommand::simulate, CaseCommand::calibrate, CaseCommand::diagnose, CaseCommand::optimize}) {
        const Result<CaseNumbers> read = numbers_in(command, "{}");
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_THAT(read->numbers, IsEmpty());
    }
}

TEST(NumbersOfAReport, WhatIsNoReportIsRefusedWithItsFile) {
    const test::Folder empty("numbers_without_a_report");
    const Result<CaseNumbers> missing = read_case_numbers(CaseCommand::diagnose, empty.path());
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().text(), HasSubstr("report.json: file not found"));
    for (const auto& [text, sentence] :
         {std::pair{"[1]", "is no report"}, std::pair{"7", "is no report"}, std::pair{"null", "is no report"},
          std::pair{R"({"signals": [{"name": "a", "values": {"x": 1}}]})", "has another form"}}) {
        const Result<CaseNumbers> read = numbers_in(CaseCommand::optimize, text);
        ASSERT_FALSE(read) << text;
        EXPECT_THAT(read.error().text(), HasSubstr("optimize.json: ")) << text;
        EXPECT_THAT(read.error().text(), HasSubstr(sentence)) << text;
    }
    EXPECT_FALSE(numbers_in(CaseCommand::optimize, R"({"signals": )"));
}

}  // namespace
}  // namespace myo::sweep::case_numbers_test
