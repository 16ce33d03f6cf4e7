#include "validation/validation_report.hpp"

#include <cmath>
#include <cstdio>
#include <set>

#include "base/text.hpp"
#include "chart/svg.hpp"

namespace myo::validation {
namespace {

/// Share in percent with one decimal, without the sign; a dash if there is none.
std::string percent(double share) {
    if (!std::isfinite(share)) return "–";
    char text[24];
    std::snprintf(text, sizeof text, "%.1f", 100.0 * share);
    return text;
}

/// Share with its counts and one bound.
///
/// @param from_below  lower bound, for shares that should be large; otherwise the upper one
report::KeyFigure key_figure(const std::string& label, const Proportion& p, bool from_below) {
    return {label, percent(p.share()), "%",
            std::to_string(p.count) + " of " + std::to_string(p.of) +
                (from_below ? ", at least " + percent(p.lower()) : ", at most " + percent(p.upper())) + " %"};
}

/// Rates with one-sided confidence bounds.
report::Table rate_table(const ValidationSummary& s) {
    report::Table table{"Bounds are one-sided at 95 % (Clopper and Pearson).",
                        {{"What"}, {"Cases"}, {"Of"}, {"Share", "%", 3}, {"At least", "%", 3}, {"At most", "%", 3}},
                        {}};
    const auto add = [&](const char* name, const Proportion& p) {
        table.rows.push_back({name, p.count, p.of, 100.0 * p.share(), 100.0 * p.lower(), 100.0 * p.upper()});
    };
    add("right first", s.top_1);
    add("right among two", s.top_2);
    add("right first, where no other effect is confounded", s.separable_top_1);
    add("right among two, there", s.separable_top_2);
    add("right, or confounded with the truth", s.in_group);
    add("effect missed (answered none)", s.missed);
    add("false alarm without an effect", s.false_alarms);
    add("deleted effect answered unknown", s.unknown);
    add("deleted effect mimicked by another, held-out trial within 1.3 noise levels", s.mimicked);
    add("deleted effects answered unknown where not mimicked", s.unknown_unmimicked);
    for (const NamedShare& row : set_proportions(s.sets)) add(row.name.c_str(), row.share);
    add("parameters within 10 %, places within 5 mm", s.parameters_good);
    return table;
}

/// Confusion matrix: truth against answer.
report::Table confusion_table(const ValidationSummary& s) {
    std::set<std::string> answers;
    for (const auto& [truth, row] : s.confusion)
        for (const auto& [answer, count] : row) answers.insert(answer);
    report::Table table{
        "Rows: truth, in brackets an effect deleted from the catalogue. Columns: answer of the diagnosis.",
        {{"Truth"}},
        {}};
    for (const std::string& answer : answers) table.columns.push_back({answer});
    for (const auto& [truth, row] : s.confusion) {
        std::vector<report::Cell> cells{truth};
        for (const std::string& answer : answers)
            cells.push_back(row.count(answer) > 0 ? report::Cell(std::to_string(row.at(answer))) : report::Cell(""));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

/// Accuracy of the parameters of correctly named effects.
report::Table parameter_table(const ValidationSummary& s) {
    report::Table table{"Parameters of effects that were named correctly.",
                        {{"Effect"}, {"Parameter"}, {"Median error"}, {"Good"}, {"Of"}},
                        {}};
    for (const ParameterQuality& q : s.parameters)
        table.rows.push_back(
            {q.effect, q.parameter,
             q.is_place ? format_number(1e3 * q.median, 3) + " mm" : format_number(100.0 * q.median, 3) + " %",
             q.good.count, q.good.of});
    return table;
}

/// Name of the case's folder.
std::string case_name(const CaseRecord& record) {
    char text[24];
    std::snprintf(text, sizeof text, "case_%04d", record.number);
    return text;
}

/// All cases with a wrong answer.
report::Table wrong_table(const std::vector<CaseRecord>& records) {
    report::Table table{"",
                        {{"Case"},
                         {"Body"},
                         {"Truth"},
                         {"Size", "× noise", 3},
                         {"Answer"},
                         {"Confidence", "", 2},
                         {"Similar to truth"},
                         {"Held out before", "× noise", 3},
                         {"After", "× noise", 3}},
                        {}};
    // Failed cases are listed as well, with their reason as answer.
    for (const CaseRecord& r : records) {
        if (r.right()) continue;
        table.rows.push_back({case_name(r), r.family + (r.muscles ? ", muscles" : ""),
                              r.kind == CaseKind::deleted ? "(" + r.truth + ")" : r.truth, r.level,
                              r.answered() ? join(r.answer, " + ") : r.failure, r.confidence, join(r.group),
                              r.before_over_noise, r.after_over_noise});
    }
    return table;
}

}  // namespace

std::string reliability_figure(const ValidationSummary& summary) {
    chart::Chart chart;
    chart.title = "Confidence and truth";
    chart.x = {.label = "stated confidence", .lowest = 0.0, .highest = 1.0};
    chart::Panel panel;
    panel.y = {.label = "share of right answers", .lowest = 0.0, .highest = 1.0};
    panel.series.push_back({.name = "ideal",
                            .x = {0.0, 1.0},
                            .y = {0.0, 1.0},
                            .style = chart::SeriesStyle::dashed,
                            .colour = chart::ink_colour});
    // Both bounds are one-sided at 95 %, together a 90 % interval.
    chart::Series found{.name = "found", .style = chart::SeriesStyle::line_and_dots, .colour = 0};
    chart::Series lower{.name = "90 % interval", .style = chart::SeriesStyle::dashed, .colour = 1},
        upper{.style = chart::SeriesStyle::dashed, .colour = 1};
    for (const ConfidenceBin& bin : summary.reliability) {
        if (bin.right.of == 0) continue;
        for (chart::Series* series : {&found, &lower, &upper}) series->x.push_back(bin.mean);
        found.y.push_back(bin.right.share());
        lower.y.push_back(bin.right.lower());
        upper.y.push_back(bin.right.upper());
    }
    panel.series.insert(panel.series.end(), {found, lower, upper});
    chart.panels.push_back(panel);
    return chart::svg(chart);
}

report::HtmlReport validation_report(const std::vector<CaseRecord>& records, const std::string& command_line) {
    const ValidationSummary s = validation_summary(records);
    report::HtmlReport report{.title = "Reliability of the diagnosis"};
    std::string families;
    for (const auto& [family, count] : s.families)
        families += (families.empty() ? "" : ", ") + std::to_string(count) + " " + family;
    report.summary = {
        std::to_string(s.cases) + " synthetic experiments (" + families +
            "), simulated with other cells, a finer mesh, a smaller step and another scheme than the diagnosis uses.",
        "An effect changes the markers' motion by 3 to 15 noise levels after recalibration has absorbed what it can to "
        "first order, and a fit leaves at least one."};
    report.key_figures = {
        key_figure("right first", s.top_1, true),
        key_figure("right among two", s.top_2, true),
        key_figure("false alarms", s.false_alarms, false),
        key_figure("deleted effects answered unknown", s.unknown, true),
        {"calibration error", format_number(s.calibration_error, 2), "", "mean distance of confidence and share right"},
        {"diagnosis", format_number(s.median_diagnose_s, 3), "s", "median, one thread"}};
    if (s.failed > 0)
        report.warnings.lines = {std::to_string(s.failed) + " cases failed and are not counted in any rate."};
    report.sections.push_back({"Rates", {rate_table(s)}});
    report.sections.push_back({"Answers", {confusion_table(s)}});
    report.sections.push_back(
        {"Confidence",
         {report::Figure{reliability_figure(s),
                         "Dots: mean confidence of a bin and the share of its answers that were right."}}});
    report.sections.push_back({"Parameters", {parameter_table(s)}});
    report::Table wrong = wrong_table(records);
    report.sections.push_back({"Wrong answers", {}});
    if (wrong.rows.empty())
        report.sections.back().blocks.push_back(report::Paragraph{"None."});
    else
        report.sections.back().blocks.push_back(std::move(wrong));
    report.sections.back().blocks.push_back(report::EmbeddedJson{"study", summary_json(s)});
    report.footer = command_line;
    return report;
}

}  // namespace myo::validation
