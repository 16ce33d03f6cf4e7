#include "results/finding_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"

namespace myo::results {
namespace {

// Order of tables and warnings.
constexpr std::array<check::CheckLevel, 3> worst_first{check::CheckLevel::wrong, check::CheckLevel::doubtful,
                                                       check::CheckLevel::passed};

// Findings of one level, in their order.
std::vector<check::Finding> of_level(const std::vector<check::Finding>& findings, check::CheckLevel level) {
    std::vector<check::Finding> list;
    std::copy_if(findings.begin(), findings.end(), std::back_inserter(list),
                 [level](const check::Finding& finding) { return finding.level == level; });
    return list;
}

// A figure with its unit; empty if the check has none.
std::string figure_words(double figure, const std::string& unit) {
    if (!std::isfinite(figure)) return {};
    return format_number(figure, 3) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

report::Json findings_json(const std::vector<check::Finding>& findings) {
    report::Json list = report::Json::array();
    for (const check::Finding& finding : findings) {
        report::Json entry{{"id", finding.check},          {"level", to_string(finding.level)},
                           {"subject", finding.subject},   {"source", finding.source},
                           {"sentence", finding.sentence}, {"way_out", finding.way_out}};
        // Some checks have no number: their keys are left out.
        if (std::isfinite(finding.figure)) entry["figure"] = finding.figure;
        if (std::isfinite(finding.threshold)) entry["threshold"] = finding.threshold;
        if (!finding.unit.empty()) entry["unit"] = finding.unit;
        list.push_back(std::move(entry));
    }
    return list;
}

report::Section findings_section(const std::vector<check::Finding>& findings) {
    report::Table table{"Assumptions of the model, with findings.",
                        {{"Check"}, {"State"}, {"Found"}, {"Figure"}, {"Threshold"}, {"Threshold from"}},
                        {}};
    for (const check::CheckLevel level : worst_first)
        for (const check::Finding& finding : of_level(findings, level))
            table.rows.push_back({finding.check, to_string(level), finding_words(finding),
                                  figure_words(finding.figure, finding.unit),
                                  figure_words(finding.threshold, finding.unit), finding.source});
    return {"Checks", {table}};
}

std::string finding_words(const check::Finding& finding) {
    return finding.way_out.empty() ? finding.sentence : finding.sentence + "; " + finding.way_out;
}

std::vector<std::string> sentences_to_report(const std::vector<check::Finding>& findings) {
    std::vector<std::string> sentences;
    for (const check::CheckLevel level : {check::CheckLevel::wrong, check::CheckLevel::doubtful})
        for (const check::Finding& finding : of_level(findings, level))
            if (!finding.warned) sentences.push_back(finding_words(finding));
    return sentences;
}

std::string findings_line(const std::vector<check::Finding>& findings) {
    std::vector<std::string> parts;
    for (const check::CheckLevel level :
         {check::CheckLevel::passed, check::CheckLevel::doubtful, check::CheckLevel::wrong}) {
        const std::vector<check::Finding> own = of_level(findings, level);
        if (own.empty()) continue;
        std::vector<std::string> names;
        for (const check::Finding& finding : own)
            // Only checks that need attention are named, each once.
            if (level != check::CheckLevel::passed &&
                std::find(names.begin(), names.end(), finding.check) == names.end())
                names.push_back(finding.check);
        parts.push_back(std::to_string(own.size()) + " " + to_string(level) +
                        (names.empty() ? "" : " (" + join(names, ", ") + ")"));
    }
    return "checks: " + join(parts, ", ");
}

}  // namespace myo::results
