#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/folder.hpp"
#include "sweep/readable_number.hpp"
#include "sweep/sweep_figures.hpp"
#include "sweep/sweep_report.hpp"
#include "sweep/sweep_table.hpp"

namespace myo::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

sweep::Varied numbers(const std::string& name, const std::vector<double>& values, bool logarithmic = false) {
    sweep::Varied varied{.name = name, .values = {}, .logarithmic = logarithmic, .where = {}};
    for (const double number : values) {
        toml::TomlValue value;
        value.kind = toml::TomlValue::Kind::number;
        value.number = number;
        varied.values.push_back(value);
    }
    return varied;
}

sweep::Varied words(const std::string& name, const std::vector<std::string>& values) {
    sweep::Varied varied{.name = name, .values = {}, .where = {}};
    for (const std::string& word : values) {
        toml::TomlValue value;
        value.kind = toml::TomlValue::Kind::text;
        value.text = word;
        varied.values.push_back(value);
    }
    return varied;
}

/// A grid of two axes whose number is 1 mm times the case, with a deviation of 0.1 mm; the third case failed.
sweep::SweepTable table_of(const sweep::Varied& slow, const sweep::Varied& fast) {
    sweep::SweepTable table;
    table.sweep.varied = {slow, fast};
    table.sweep.command = sweep::CaseCommand::calibrate;
    table.experiment_name = "beam";
    table.columns = {{"rms of the fit", "m", true, true}, {"evaluations", "", false, false}};
    for (std::size_t i = 0; i < slow.values.size(); ++i)
        for (std::size_t k = 0; k < fast.values.size(); ++k) {
            sweep::SweepRow row;
            row.number = static_cast<int>(table.rows.size()) + 1;
            row.choice = {i, k};
            row.state = row.number == 3 ? sweep::CaseState::failed : sweep::CaseState::done;
            if (row.number == 3)
                row.message = "no, \"never\"";
            else
                row.result.numbers = {{"rms of the fit", "m", 1e-3 * row.number, 1e-4, true},
                                      {"evaluations", "", 7.0, std::nan(""), false}};
            table.rows.push_back(row);
        }
    return table;
}

const sweep::Varied moduli = numbers("material.youngs_modulus_Pa", {1e5, 2e5, 4e5}, true);
const sweep::Varied elements = words("--element", {"hex8", "tet10"});

TEST(SweepTable, CsvQuotesWhatHoldsSeparators) {
    const std::string csv = sweep::csv_text(table_of(moduli, elements));
    EXPECT_THAT(csv, HasSubstr("case,material.youngs_modulus_Pa,--element,state,verdict,rms of the fit [m],"
                               "std of rms of the fit [m],evaluations,seconds [s],message\r\n"
                               "1,100000,hex8,done,,0.001,1e-04,7,0,\r\n"));
    EXPECT_THAT(csv, HasSubstr("\r\n3,200000,hex8,failed,,,,,0,\"no, \"\"never\"\"\"\r\n"));
}

TEST(SweepTable, JsonHoldsEveryRowInSiUnits) {
    const report::Json json = sweep::sweep_json(table_of(moduli, elements), "0.1", {"myoloop", "sweep"});
    EXPECT_EQ(json.at("schema"), "sweep_result/1");
    EXPECT_EQ(json.at("done"), 5);
    EXPECT_EQ(json.at("failed"), 1);
    const report::Json& row = json.at("rows").at(5);
    EXPECT_EQ(row.at("values").at("material.youngs_modulus_Pa"), 4e5);
    EXPECT_EQ(row.at("values").at("--element"), "tet10");
    EXPECT_EQ(row.at("numbers").at("rms of the fit"), (report::Json{{"value", 6e-3}, {"unit", "m"}, {"std", 1e-4}}));
    EXPECT_EQ(row.at("folder"), "cases/0006");
}

TEST(SweepFigures, CurvesRunOverNumbersWithUnitsAndGaps) {
    const sweep::SweepFigures figures = sweep::sweep_figures(table_of(moduli, elements));
    ASSERT_EQ(figures.charts.size(), 1u);  // evaluations are in the files only
    const chart::Chart& chart = figures.charts.front();
    EXPECT_EQ(chart.x.label, "material.youngs modulus");
    EXPECT_EQ(chart.x.unit, "kPa");
    EXPECT_TRUE(chart.x.logarithmic);
    const chart::Panel& panel = chart.panels.front();
    EXPECT_EQ(panel.y.unit, "mm");
    ASSERT_EQ(panel.series.size(), 2u);
    EXPECT_EQ(panel.series[0].name, "--element hex8");
    EXPECT_THAT(panel.series[1].x, ElementsAre(100.0, 200.0, 400.0));
    EXPECT_THAT(panel.series[1].y, ElementsAre(2.0, 4.0, 6.0));
    EXPECT_TRUE(std::isnan(panel.series[0].y[1]));
    EXPECT_DOUBLE_EQ(panel.series[1].half_width[2], 0.1);
}

TEST(SweepFigures, NamesAreCategoriesAndManyCurvesAreNone) {
    const sweep::SweepFigures named = sweep::sweep_figures(table_of(elements, words("--mass", {"consistent"})));
    EXPECT_THAT(named.charts.front().x.categories, ElementsAre("hex8", "tet10"));
    const sweep::Varied nine = words("trial[0].start", {"1", "2", "3", "4", "5", "6", "7", "8", "9"});
    const sweep::SweepFigures none = sweep::sweep_figures(table_of(nine, moduli));
    EXPECT_TRUE(none.charts.empty());
    EXPECT_THAT(none.missing, HasSubstr("9 curves"));
    EXPECT_FALSE(sweep::sweep_figures(table_of(elements, moduli)).charts.empty());
}

TEST(SweepFigures, ThePageShowsThemWithTheFailedCases) {
    const std::string page = report::html(sweep::sweep_report(table_of(moduli, elements), "myoloop sweep"));
    for (const char* text : {"<svg", "case 3 failed: no, &quot;never&quot;", "rms of the fit", "kPa", "cases done"})
        EXPECT_THAT(page, HasSubstr(text));
}

TEST(ReadableNumber, HasTheUnitOfTheNumberOrOfItsName) {
    EXPECT_EQ(sweep::words_of({"youngs_modulus_Pa", "Pa", 267455.0, 3600.0}), "267.5 ± 3.6 kPa");
    EXPECT_EQ(sweep::words_of({"quadratic_drag.coefficient_kg_m3", "", 28.7}), "28.7 kg/m³");
    EXPECT_EQ(sweep::words_of({"confidence", "", 0.93}), "0.93");
    EXPECT_EQ(sweep::shown_quantity("youngs_modulus_Pa", "Pa").name, "youngs modulus");
    EXPECT_EQ(sweep::shown_quantity(numbers("trial.tip_weight.load[0].mass_kg", {})).name,
              "trial.tip_weight.load[0].mass");
}

TEST(CaseNumbers, OfADiagnosisAreTheVerdictAndItsParameters) {
    const Folder folder("case_numbers");
    folder.write("report.json", R"({"verdict": {"effects": [
        {"id": "linear_drag", "parameters": {"coefficient": 2.5, "axis": [0, 0, 1]}}, {"id": "tilt", "parameters": {}}],
        "confidence": 0.8}, "declared_fit": {"rms_m": 0.003, "parameters": {}}, "validation": {"before_rms_m": null},
        "augmented_fit": {"rms_m": 0.001, "parameters": {"youngs_modulus_Pa": 2e5}},
        "trials": [{"name": "pull", "after_rms_m": 0.002}]})");
    const Result<sweep::CaseNumbers> read = sweep::read_case_numbers(sweep::CaseCommand::diagnose, folder.path());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->verdict, "linear_drag + tilt");
    std::vector<std::string> names;
    for (const sweep::CaseNumber& number : read->numbers) names.push_back(number.name);
    EXPECT_THAT(names, ElementsAre("confidence", "linear_drag.coefficient", "linear_drag.axis[0]",
                                   "linear_drag.axis[1]", "linear_drag.axis[2]", "rms of the declared fit",
                                   "rms of the fit", "youngs_modulus_Pa", "rms of pull"));
}

TEST(CaseNumbers, OfASearchAreWhatIsHeldAndSought) {
    const Folder folder("case_search");
    folder.write("optimize.json", R"({"converged": true, "reached": false, "rms_after_m": 0.001, "signals": [
        {"name": "left", "unit": "Pa", "values": [2000], "std": [30]},
        {"name": "right", "unit": "Pa", "values": [1, 2, 3]}],
        "design": {"items": [{"item": "modulus", "youngs_modulus_Pa": 1e5}]}})");
    const Result<sweep::CaseNumbers> read = sweep::read_case_numbers(sweep::CaseCommand::optimize, folder.path());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->verdict, "not reached");
    ASSERT_EQ(read->numbers.size(), 3u);
    EXPECT_EQ(read->numbers[1].name, "left");
    EXPECT_EQ(read->numbers[1].deviation, 30.0);
    EXPECT_EQ(read->numbers[2].name, "modulus.youngs_modulus_Pa");
}

}  // namespace
}  // namespace myo::test
