#include "results/calibration_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "results/calibration_report_parts.hpp"
#include "results/finding_output.hpp"
#include "support/made_calibration.hpp"
#include "support/swung_beam.hpp"

namespace myo::results {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::string text_of(const report::Cell& cell) {
    const auto* text = std::get_if<std::string>(&cell.content);
    return text != nullptr ? *text : std::string("a number");
}
double number_of(const report::Cell& cell) {
    const auto* number = std::get_if<double>(&cell.content);
    return number != nullptr ? *number : 1e300;
}

class CalibrationReport : public testing::Test {
protected:
    CalibrationReport()
        : folder_("calibration_report"),
          setup_(test::swung_beam(folder_, 0.1)),
          made_(test::made_calibration(setup_)) {}

    report::HtmlReport page(const RunFacts& facts = {}) const { return calibration_report(setup_, made_, facts); }
    std::vector<std::string> titles() const {
        std::vector<std::string> list;
        for (const report::Section& section : page().sections) list.push_back(section.title);
        return list;
    }

    test::Folder folder_;
    setup::Setup setup_;
    calibration::Calibration made_;
};

TEST_F(CalibrationReport, ShowsParametersInReadableUnits) {
    const report::Table table = parameter_table(setup_, made_);
    ASSERT_EQ(table.rows.size(), 2u);
    std::vector<std::string> row;
    for (const report::Cell& cell : table.rows[0]) row.push_back(text_of(cell));
    EXPECT_THAT(row, ElementsAre("Young's modulus E", "kPa", "250.0", "1.3", "0.30", "0.40", "1.2", "260.0"));
    EXPECT_EQ(text_of(table.rows[1][1]), "ms");
    EXPECT_EQ(text_of(table.rows[1][2]), "4.00");
    EXPECT_EQ(text_of(table.rows[1][3]), "0.10");
    made_.numerical.step.resize(0);
    EXPECT_EQ(text_of(parameter_table(setup_, made_).rows[0][6]), "–");
    made_.fit.deviations(0) = std::nan("");
    EXPECT_EQ(text_of(parameter_table(setup_, made_).rows[0][3]), "–");
}

TEST_F(CalibrationReport, ShowsTrialsInMillimetres) {
    const report::Table table = trial_table(setup_, made_);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(text_of(table.rows[0][1]), "fit");
    EXPECT_EQ(text_of(table.rows[1][1]), "predicted");
    EXPECT_NEAR(number_of(table.rows[0][2]), 3.0 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(number_of(table.rows[0][3]), 0.3 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(number_of(table.rows[0][4]), 0.3, 1e-12);
    EXPECT_NEAR(number_of(table.rows[1][4]), 0.6, 1e-12);
    // The worst marker counts, and one that was never seen does not.
    made_.after.scores[0].markers[1].steady_error_m = std::nan("");
    made_.after.scores[0].markers[2].steady_error_m = 2e-3;
    EXPECT_NEAR(number_of(trial_table(setup_, made_).rows[0][4]), 2.0, 1e-12);
    made_.after = test::with_failure(setup_, made_.after, 0, "it broke");
    EXPECT_TRUE(std::isnan(number_of(trial_table(setup_, made_).rows[0][3])));
    EXPECT_TRUE(std::isnan(number_of(trial_table(setup_, made_).rows[0][4])));
}

TEST_F(CalibrationReport, ShowsEachStart) {
    made_.starts.push_back({inverse::FitStatus::not_converged, "", made_.fit.start, {}, 0.0, 0.0, {}});
    const report::Table table = starts_table(setup_, made_);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.columns.back().unit, "ms");
    EXPECT_EQ(number_of(table.rows[0][0]), 1.0);
    EXPECT_EQ(number_of(table.rows[0][2]), 2.0);
    EXPECT_EQ(number_of(table.rows[0][4]), 2.0);
    EXPECT_NEAR(number_of(table.rows[0][5]), 250.0, 1e-9);
    EXPECT_NEAR(number_of(table.rows[0][6]), 4.0, 1e-12);
    EXPECT_EQ(text_of(table.rows[1][1]), "not converged");
    EXPECT_TRUE(std::isnan(number_of(table.rows[1][3])));
    EXPECT_TRUE(std::isnan(number_of(table.rows[1][5])));
}

TEST_F(CalibrationReport, LeadsWithItsFigures) {
    const std::vector<report::KeyFigure> figures = page().key_figures;
    ASSERT_EQ(figures.size(), 4u);
    EXPECT_EQ(figures[0].value, "250.0");
    EXPECT_EQ(figures[0].unit, "kPa");
    EXPECT_EQ(figures[0].note, "± 1.3 kPa, declared 260.0 kPa");
    EXPECT_EQ(figures[1].value, "4.00");
    EXPECT_THAT(figures[1].note, StartsWith("± 0.10 ms"));
    EXPECT_EQ(figures[2].label, "Fit error (rms)");
    EXPECT_EQ(figures[2].unit, "mm");
    EXPECT_THAT(figures[2].value, StartsWith("0.173"));
    EXPECT_EQ(figures[3].label, "Prediction error (rms)");
    made_.after = test::with_failure(setup_, made_.after, 1, "it broke");
    EXPECT_EQ(page().key_figures.size(), 3u);
    made_.fit.undetermined = {{{0}, 0, {}}};
    made_.fit.deviations(0) = std::nan("");
    EXPECT_THAT(page().key_figures[0].note, StartsWith("not determined: it has no influence on the data"));
}

TEST_F(CalibrationReport, SumsUpTrialsAndCost) {
    setup_.experiment.description = "A beam.";
    EXPECT_THAT(page().summary, ElementsAre("Calibrated on 1 trial; 1 trial is predicted with the result. The fit "
                                            "converged after 2 evaluations in 1.50 s.",
                                            "A beam."));
    made_.fit.status = inverse::FitStatus::cancelled;
    made_.stopped = true;
    EXPECT_THAT(page().summary.front(), HasSubstr("The fit was stopped after"));
}

TEST_F(CalibrationReport, SaysHowTheFitEnded) {
    setup_.warnings.clear();
    EXPECT_THAT(page().warnings.lines, ElementsAre());
    made_.warnings = {"of the fit"};
    setup_.warnings = {"of the setup"};
    RunFacts facts;
    facts.findings.resize(2);
    facts.findings[0].sentence = "all is well";
    facts.findings[1].level = check::CheckLevel::wrong;
    facts.findings[1].sentence = "found";
    made_.fit.status = inverse::FitStatus::not_converged;
    made_.fit.message = "too many evaluations";
    EXPECT_THAT(page(facts).warnings.lines,
                ElementsAre("The fit did not converge: too many evaluations", "found", "of the fit", "of the setup"));
    made_.stopped = true;
    EXPECT_THAT(page().warnings.lines.front(), StartsWith("The user stopped the fit before it converged"));
    made_.fit.status = inverse::FitStatus::converged;
    EXPECT_EQ(page().warnings.lines.front(), "The user stopped before all trials were predicted.");
}

TEST_F(CalibrationReport, HasASectionPerTrialAndOneOfTheModel) {
    const std::vector<std::string> all = titles();
    EXPECT_EQ(all.front(), "Trials");
    EXPECT_EQ(all[1], "Parameters");
    EXPECT_EQ(all.back(), "Model and data");
    EXPECT_EQ(all.size(), 5u);
    RunFacts facts;
    facts.findings.resize(1);
    EXPECT_EQ(page(facts).sections[1].title, "Checks");
}

TEST_F(CalibrationReport, ModelSectionHasTheMassOfTheBody) {
    const report::Section section = model_section(setup_, made_);
    const auto& facts = std::get<report::Table>(section.blocks.front().content);
    // 0.1 x 0.03 x 0.03 m3 of 1070 kg/m3.
    EXPECT_EQ(text_of(facts.rows[0][1]), "90.00 cm³, 96.30 g");
    EXPECT_THAT(text_of(facts.rows.back()[1]), StartsWith("tr_bdf2, steps of 5"));
    const auto& noise = std::get<report::Table>(section.blocks[1].content);
    ASSERT_EQ(noise.rows.size(), 4u);
    EXPECT_NEAR(number_of(noise.rows[3][1]), 0.1, 1e-15);
    EXPECT_THAT(noise.caption, HasSubstr("as declared"));
}

TEST_F(CalibrationReport, EmbedsTheResultFile) {
    RunFacts facts;
    facts.version = "9.9";
    facts.command = {"myoloop", "calibrate", "x"};
    const report::HtmlReport report = page(facts);
    EXPECT_EQ(report.footer, "Myoloop 9.9 — myoloop calibrate x");
    const auto& embedded = std::get<report::EmbeddedJson>(report.sections.back().blocks.back().content);
    EXPECT_EQ(embedded.value, calibrate_json(setup_, made_, facts));
    EXPECT_THAT(report::html(report), HasSubstr("calibrate/1"));
}

TEST(FindingOutput, TableIsSortedByLevel) {
    std::vector<check::Finding> findings{check::passed_finding("", "fine"), check::passed_finding("", "bad")};
    findings[0].check = "mesh";
    findings[0].figure = 0.123456;
    findings[0].threshold = 2.0;
    findings[0].unit = "mm";
    findings[0].source = "a paper";
    findings[1].level = check::CheckLevel::wrong;
    findings[1].check = "step";
    findings[1].way_out = "shorten it";
    const report::Section section = findings_section(findings);
    const auto& table = std::get<report::Table>(section.blocks.front().content);
    std::vector<std::string> worst, best;
    for (const report::Cell& cell : table.rows[0]) worst.push_back(text_of(cell));
    for (const report::Cell& cell : table.rows[1]) best.push_back(text_of(cell));
    EXPECT_THAT(worst, ElementsAre("step", "red", "bad; shorten it", "", "", ""));
    EXPECT_THAT(best, ElementsAre("mesh", "green", "fine", "0.123 mm", "2 mm", "a paper"));
    const report::Json json = findings_json(findings);
    EXPECT_EQ(json[0]["figure"], 0.123456);
    EXPECT_EQ(json[0]["threshold"], 2.0);
    EXPECT_EQ(json[0]["level"], "green");
    EXPECT_FALSE(json[1].contains("unit"));
    EXPECT_EQ(json[1]["way_out"], "shorten it");
    EXPECT_EQ(findings_line({}), "checks: ");
}

}  // namespace
}  // namespace myo::results
