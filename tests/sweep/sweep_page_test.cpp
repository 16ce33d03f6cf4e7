#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "base/files.hpp"
#include "support/folder.hpp"
#include "sweep/sweep_figures.hpp"
#include "sweep/sweep_report.hpp"
#include "sweep/sweep_table.hpp"
#include "toml/toml_value.hpp"

// Axes, curves and columns of a sweep's page and files, for tables with few and with missing numbers.

namespace myo::sweep::sweep_page_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

const double not_there = std::numeric_limits<double>::quiet_NaN();

/// A varied quantity with values as they are typed.
Varied quantity(const std::string& name, const std::vector<std::string>& typed, bool together = false) {
    Varied made{.name = name, .values = {}, .together = together, .where = {}};
    for (const std::string& text : typed) made.values.push_back(*toml::parse_toml_value(text, ""));
    return made;
}

/// A table of the whole grid whose only number, in metres, is the number of its case.
SweepTable grid_of(const std::vector<Varied>& varied) {
    SweepTable table;
    table.sweep.varied = varied;
    table.sweep.command = CaseCommand::calibrate;
    table.columns = {{"sag", "m"}};
    const std::vector<std::size_t> sizes = axis_sizes(table.sweep);
    for (std::size_t rank = 0; rank < case_count(table.sweep); ++rank) {
        SweepRow row;
        row.number = static_cast<int>(rank) + 1;
        std::size_t rest = rank, axis = sizes.size();
        std::vector<std::size_t> digits(sizes.size());
        while (axis-- > 0) digits[axis] = rest % sizes[axis], rest /= sizes[axis];
        for (const Varied& one : varied) row.choice.push_back(digits[one.together ? axis : ++axis]);
        row.state = CaseState::done;
        row.result.numbers = {{"sag", "m", 1.0 * row.number}};
        table.rows.push_back(row);
    }
    return table;
}

chart::Chart only_chart(const SweepFigures& figures) {
    const chart::Chart none;
    EXPECT_EQ(figures.charts.size(), 1u) << figures.missing;
    return figures.charts.empty() ? none : figures.charts.front();
}

TEST(SweepPage, CurvesRunAlongNumbersBeforeNamesAndNeverAlongSeeds) {
    const Varied element = quantity("--element", {"hex8", "tet10", "tet4"}), damping = quantity("a", {"1", "2"}),
                 seed = quantity("--seed", {"1", "2", "3", "4"}), more = quantity("b", {"1", "2", "3"});
    const auto along = [](const std::vector<Varied>& varied) {
        return only_chart(sweep_figures(grid_of(varied), {.most_curves = 100})).x.label;
    };
    EXPECT_EQ(along({element, damping}), "a");
    EXPECT_EQ(along({element, damping, seed}), "a");
    EXPECT_EQ(along({element, seed}), "--element");
    EXPECT_EQ(along({damping, more}), "b");
    EXPECT_EQ(along({more, damping}), "b");
    // Among equal ones the slowest, which is named first in the file.
    EXPECT_EQ(along({damping, quantity("c", {"1", "2"})}), "a");
    EXPECT_EQ(along({seed}), "--seed");
}

TEST(SweepPage, ASingleCaseHasNoFigure) {
    const SweepFigures figures = sweep_figures(grid_of({quantity("a", {"1"}), quantity("--seed", {"7"})}));
    EXPECT_THAT(figures.charts, IsEmpty());
    EXPECT_EQ(figures.missing, "A single case needs no figure.");
}

TEST(SweepPage, AsManyCurvesAsTheColoursAllowButNoMore) {
    const std::vector<Varied> varied{quantity("a", {"1", "2", "3"}), quantity("--x", {"p", "q"})};
    const SweepTable table = grid_of(varied);
    EXPECT_EQ(only_chart(sweep_figures(table, {.most_curves = 2})).panels.front().series.size(), 2u);
    const SweepFigures none = sweep_figures(table, {.most_curves = 1});
    EXPECT_THAT(none.charts, IsEmpty());
    EXPECT_THAT(none.missing, HasSubstr("2 curves in a figure, more than 1"));
}

TEST(SweepPage, CurvesHaveNamesColoursAndGaps) {
    SweepTable table = grid_of(
        {quantity("clamp.stiffness_Pa", {"1e3", "2e3"}), quantity("length_m", {"0.1", "0.2", "0.3"})});
    table.columns[0].has_deviation = true;
    table.rows[1].result.numbers.clear();
    table.rows[2].result.numbers[0].deviation = 0.5;
    const chart::Chart chart = only_chart(sweep_figures(table));
    EXPECT_EQ(chart.title, "sag");
    EXPECT_EQ(chart.x.label, "length");
    EXPECT_EQ(chart.x.unit, "mm");
    EXPECT_FALSE(chart.x.logarithmic);
    EXPECT_THAT(chart.x.categories, IsEmpty());
    const std::vector<chart::Series>& series = chart.panels.front().series;
    ASSERT_EQ(series.size(), 2u);
    EXPECT_EQ(series[0].name, "clamp.stiffness 1 kPa");
    EXPECT_EQ(series[1].name, "clamp.stiffness 2 kPa");
    EXPECT_EQ(series[0].colour, 0);
    EXPECT_EQ(series[1].colour, 1);
    EXPECT_EQ(series[0].style, chart::SeriesStyle::line_and_dots);
    EXPECT_THAT(series[1].y, ElementsAre(4e3, 5e3, 6e3));
    // The case without a number is a gap at its place, and a band where no deviation is known has no width.
    ASSERT_EQ(series[0].x.size(), 3u);
    EXPECT_TRUE(std::isnan(series[0].y[1]));
    EXPECT_EQ(series[0].y[2], 3e3);
    EXPECT_THAT(series[0].half_width, ElementsAre(0.0, 0.0, 500.0));
}

TEST(SweepPage, NamesAreDotsAtTheirPlacesAndQuantitiesThatMoveAlongAreNamed) {
    const SweepTable words = grid_of({quantity("trial[0].start", {"straight", "equilibrium"}),
                                      quantity("load_N", {"1", "2"}, true), quantity("width_m", {"1", "2"}, true)});
    ASSERT_EQ(words.rows.size(), 2u);
    const chart::Chart chart = only_chart(sweep_figures(words));
    EXPECT_EQ(chart.x.label, "trial[0].start (with load, width)");
    EXPECT_THAT(chart.x.categories, ElementsAre("straight", "equilibrium"));
    EXPECT_EQ(chart.x.unit, "");
    const chart::Series& dots = chart.panels.front().series.front();
    EXPECT_EQ(dots.style, chart::SeriesStyle::dots);
    EXPECT_THAT(dots.x, ElementsAre(0.0, 1.0));
    EXPECT_EQ(dots.name, "");
    EXPECT_THAT(dots.half_width, IsEmpty());
    // An infinite value has no place on an axis of numbers.
    EXPECT_THAT(only_chart(sweep_figures(grid_of({quantity("a", {"1.0", "inf"})}))).x.categories,
                ElementsAre("1", "inf"));
}

TEST(SweepPage, EveryShownColumnHasItsFigure) {
    SweepTable table = grid_of({quantity("a", {"1", "2"})});
    table.columns = {{"steps", "", false, false}, {"sag", "m"}, {"damping_s", "s"}};
    const SweepFigures figures = sweep_figures(table);
    ASSERT_EQ(figures.charts.size(), 2u);
    EXPECT_EQ(figures.charts[0].panels.front().y.unit, "mm");
    EXPECT_EQ(figures.charts[1].title, "damping");
    EXPECT_EQ(figures.charts[1].panels.front().y.unit, "ms");
}

/// Titles of the table of cases.
std::vector<std::string> titles_in(const report::HtmlReport& page) {
    std::vector<std::string> titles;
    for (const report::Section& section : page.sections)
        for (const report::Block& block : section.blocks)
            if (const auto* const table = std::get_if<report::Table>(&block.content))
                for (const report::Column& column : table->columns) titles.push_back(column.title);
    return titles;
}

TEST(SweepPage, ColumnsOfTheTableFollowWhatThereIs) {
    SweepTable table = grid_of({quantity("length_m", {"1", "2"})});
    EXPECT_THAT(titles_in(sweep_report(table, "")), ElementsAre("Case", "length", "State", "sag", "Time"));
    table.columns[0].has_deviation = true;
    table.rows[1].result.verdict = "converged";
    table.columns.push_back({"steps", "", false, false});
    EXPECT_THAT(titles_in(sweep_report(table, "")),
                ElementsAre("Case", "length", "State", "Verdict", "sag", "±", "Time"));
}

TEST(SweepPage, CountsAndWarningsAreOfTheStates) {
    SweepTable table = grid_of({quantity("a", {"1", "2", "3", "4", "5", "6"})});
    const CaseState states[] = {CaseState::done,    CaseState::unconverged, CaseState::failed,
                                CaseState::not_run, CaseState::running,     CaseState::stopped};
    for (std::size_t i = 0; i < 6; ++i) table.rows[i].state = states[i], table.rows[i].seconds = 0.25;
    table.rows[1].message = "more steps";
    table.rows[2].message = "no memory";
    for (const CaseState state : states) EXPECT_EQ(table.count(state), 1) << to_string(state);
    EXPECT_EQ(table.missing(), 3);
    const report::HtmlReport page = sweep_report(table, "myoloop sweep x");
    EXPECT_THAT(page.warnings.lines, ElementsAre("3 cases not run yet; the table is incomplete.",
                                                 "case 2 not converged: more steps", "case 3 failed: no memory"));
    EXPECT_THAT(page.summary, ElementsAre("myoloop calibrate, 6 cases."));
    ASSERT_EQ(page.key_figures.size(), 4u);
    EXPECT_EQ(page.key_figures[0].value + page.key_figures[1].value + page.key_figures[2].value, "111");
    EXPECT_EQ(page.key_figures[0].note, "of 6");
    EXPECT_EQ(page.key_figures[3].value, "1.5");
    EXPECT_EQ(page.footer, "myoloop sweep x");
    const report::Json json = sweep_json(table, "0.1", {});
    EXPECT_EQ(json.at("cases"), 6);
    EXPECT_EQ(json.at("not_converged"), 1);
    EXPECT_EQ(json.at("missing"), 3);
    EXPECT_EQ(json.at("rows").at(2).at("message"), "no memory");
    EXPECT_FALSE(json.at("rows").at(0).contains("message"));
    SweepTable one = grid_of({quantity("a", {"1"})});
    one.sweep.arguments = {"--dt", "0.01"};
    one.rows[0].state = CaseState::stopped;
    EXPECT_THAT(sweep_report(one, "").summary, ElementsAre("myoloop calibrate --dt 0.01, 1 case."));
    EXPECT_THAT(sweep_report(one, "").warnings.lines, ElementsAre("1 case not run yet; the table is incomplete."));
}

TEST(SweepPage, FilesHoldEveryKindOfValue) {
    SweepTable table = grid_of({quantity("a", {"[1, true]"}), quantity("b", {"{x = 1.5, y = \"w\"}"}),
                                quantity("--flag", {"true"}), quantity("c", {"\"p,q\""})});
    table.rows[0].result.numbers = {{"sag", "m", not_there, 0.1}};
    table.columns[0].has_deviation = true;
    const report::Json row = sweep_json(table, "0.1", {}).at("rows").at(0);
    EXPECT_EQ(row.at("values").dump(), R"({"a":[1.0,true],"b":{"x":1.5,"y":"w"},"--flag":true,"c":"p,q"})");
    EXPECT_TRUE(row.at("numbers").at("sag").at("value").is_null());
    EXPECT_EQ(row.at("numbers").at("sag").at("std"), 0.1);
    const std::string csv = csv_text(table);
    EXPECT_THAT(csv, StartsWith("case,a,b,--flag,c,state,verdict,sag [m],std of sag [m],seconds [s],message\r\n"));
    EXPECT_THAT(csv, HasSubstr("\r\n1,\"[1.0, true]\",\"{x = 1.5, y = \"\"w\"\"}\",true,\"p,q\",done,,,0.1,0,\r\n"));
}

TEST(SweepPage, ALineOfTheTerminalHasWhatIsShown) {
    SweepTable table = grid_of({quantity("material.damping_s", {"0.004"}), quantity("--dt", {"0.5"})});
    SweepRow& row = table.rows[0];
    row.seconds = 12.34;
    row.result.verdict = "converged";
    row.result.numbers.push_back({"steps", "", 40.0, not_there, false});
    EXPECT_EQ(row_line(table.sweep, row),
              "    1  material.damping_s = 0.004, --dt = 0.5  done  converged  sag 1000 mm  12.3 s");
    row.state = CaseState::stopped;
    row.message = "why";
    EXPECT_THAT(row_line(table.sweep, row), Not(HasSubstr("12.3 s")));
    EXPECT_THAT(row_line(table.sweep, row), HasSubstr("  why"));
}

TEST(SweepPage, IsWrittenBesideItsFilesWithTheSweepFile) {
    const test::Folder folder("sweep_page");
    folder.write("sweep.toml", "# a < b\n");
    SweepTable table = grid_of({quantity("a", {"1", "2"})});
    table.sweep.file = folder.path() / "sweep.toml";
    ASSERT_TRUE(write_sweep(table, folder.path(), "0.1", {"myoloop", "sweep", "x"}));
    EXPECT_EQ(*read_file(folder.path() / "sweep.csv"), csv_text(table));
    EXPECT_EQ(report::read_json(folder.path() / "sweep.json")->at("call").dump(), R"(["myoloop","sweep","x"])");
    const std::string page = *read_file(folder.path() / "sweep.html");
    EXPECT_THAT(page, HasSubstr("# a &lt; b"));
    EXPECT_THAT(page, HasSubstr("<footer>myoloop sweep x</footer>"));
    EXPECT_FALSE(write_sweep(table, folder.path() / "sweep.toml", "0.1", {}));
}

}  // namespace
}  // namespace myo::sweep::sweep_page_test
