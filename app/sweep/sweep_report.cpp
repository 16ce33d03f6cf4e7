#include "sweep/sweep_report.hpp"

#include <algorithm>
#include <cmath>

#include "base/files.hpp"
#include "base/text.hpp"
#include "chart/svg.hpp"
#include "sweep/readable_number.hpp"
#include "sweep/sweep_figures.hpp"

namespace myo::sweep {
namespace {

/// "1 case", "3 cases".
std::string counted(int count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

/// Whether a condition holds for some row.
bool any_row(const SweepTable& table, const auto& holds) {
    return std::any_of(table.rows.begin(), table.rows.end(), holds);
}

/// Cells of a row in the order of the columns of result_table(), in shown units.
///
/// @param verdicts  the table has a column of verdicts
std::vector<report::Cell> cells_of(const SweepTable& table, const SweepRow& row, bool verdicts) {
    std::vector<report::Cell> cells{row.number};
    for (std::size_t k = 0; k < table.sweep.varied.size(); ++k) {
        const Varied& varied = table.sweep.varied[k];
        const toml::TomlValue& value = varied.values[row.choice[k]];
        if (value.kind == toml::TomlValue::Kind::number)
            cells.emplace_back(shown_quantity(varied).factor * value.number);
        else
            cells.emplace_back(value_words(varied, row.choice[k]));
    }
    cells.emplace_back(to_string(row.state));
    if (verdicts) cells.emplace_back(row.result.verdict);
    for (const SweepColumn& column : table.columns) {
        if (!column.shown) continue;
        const double factor = shown_quantity(column.name, column.unit).factor;
        const CaseNumber* number = row.find(column.name);
        cells.emplace_back(number != nullptr ? factor * number->value : std::nan(""));
        if (column.has_deviation) cells.emplace_back(number != nullptr ? factor * number->deviation : std::nan(""));
    }
    cells.emplace_back(row.seconds);
    return cells;
}

/// Table of the page: varied values, state, verdict, shown numbers with their deviations, time.
report::Table result_table(const SweepTable& table) {
    // `simulate` has no verdicts, and needs no column for them.
    const bool verdicts = any_row(table, [](const SweepRow& row) { return !row.result.verdict.empty(); });
    report::Table page{
        "Every case has its folder, cases/0001 and so on, with its experiment and the command's own "
        "reports. sweep.csv holds more numbers, in SI units.",
        {{"Case"}},
        {}};
    for (const Varied& varied : table.sweep.varied) {
        const ShownQuantity shown = shown_quantity(varied);
        page.columns.push_back({shown.name, shown.unit});
    }
    page.columns.push_back({"State"});
    if (verdicts) page.columns.push_back({"Verdict"});
    for (const SweepColumn& column : table.columns) {
        if (!column.shown) continue;
        const ShownQuantity shown = shown_quantity(column.name, column.unit);
        page.columns.push_back({shown.name, shown.unit});
        if (column.has_deviation) page.columns.push_back({"±", shown.unit, 2});
    }
    page.columns.push_back({"Time", "s", 3});
    for (const SweepRow& row : table.rows) page.rows.push_back(cells_of(table, row, verdicts));
    return page;
}

/// Figures of the shown numbers, or the reason why there are none.
report::Section figure_section(const SweepTable& table) {
    report::Section section{"Figures", {}};
    const SweepFigures figures = sweep_figures(table);
    if (!figures.missing.empty()) section.blocks.emplace_back(report::Paragraph{figures.missing});
    // Figures follow the order of the shown columns.
    std::size_t at = 0;
    for (const SweepColumn& column : table.columns) {
        if (!column.shown || at >= figures.charts.size()) continue;
        section.blocks.emplace_back(report::Figure{chart::svg(figures.charts[at++]),
                                                   column.has_deviation ? "Bands: one standard deviation." : ""});
    }
    return section;
}

}  // namespace

report::HtmlReport sweep_report(const SweepTable& table, const std::string& call) {
    const int count = static_cast<int>(table.rows.size());
    report::HtmlReport page{.title = "Sweep of " + table.experiment_name};
    page.summary = {"myoloop " + to_string(table.sweep.command) +
                    (table.sweep.arguments.empty() ? "" : " " + join(table.sweep.arguments, " ")) + ", " +
                    counted(count, "case") + "."};
    double seconds = 0.0;
    for (const SweepRow& row : table.rows) seconds += row.seconds;
    page.key_figures = {{"cases done", std::to_string(table.count(CaseState::done)), "", "of " + std::to_string(count)},
                        {"not converged", std::to_string(table.count(CaseState::unconverged)), "", ""},
                        {"failed", std::to_string(table.count(CaseState::failed)), "", ""},
                        {"time of all cases", format_number(seconds, 3), "s", "one thread each"}};
    if (table.missing() > 0)
        page.warnings.lines.push_back(counted(table.missing(), "case") + " not run yet; the table is incomplete.");
    for (const SweepRow& row : table.rows)
        if (row.state == CaseState::failed || row.state == CaseState::unconverged)
            page.warnings.lines.push_back("case " + std::to_string(row.number) + " " + to_string(row.state) + ": " +
                                          row.message);
    page.sections.push_back(figure_section(table));
    page.sections.push_back({"Cases", {result_table(table)}});
    // A copy of the file on the page: the sweep can be repeated from it.
    if (const Result<std::string> text = read_file(table.sweep.file); text)
        page.sections.push_back({"Sweep file", {report::Preformatted{*text}}});
    page.footer = call;
    return page;
}

Result<void> write_sweep(const SweepTable& table, const std::filesystem::path& out, const std::string& version,
                         const std::vector<std::string>& command) {
    if (const Result<void> csv = write_file(out / "sweep.csv", csv_text(table)); !csv) return csv;
    if (const Result<void> json = report::write_json(out / "sweep.json", sweep_json(table, version, command)); !json)
        return json;
    return report::write_html(out / "sweep.html", sweep_report(table, join(command, " ")));
}

}  // namespace myo::sweep
