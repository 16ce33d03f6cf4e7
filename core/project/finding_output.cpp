#include "project/finding_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"

namespace myo {
namespace {

constexpr std::array<CheckLevel, 3> worst_first{CheckLevel::wrong, CheckLevel::doubtful, CheckLevel::fine};

std::vector<Finding> of_level(const std::vector<Finding>& findings, CheckLevel level) {
    std::vector<Finding> list;
    std::copy_if(findings.begin(), findings.end(), std::back_inserter(list),
                 [level](const Finding& finding) { return finding.level == level; });
    return list;
}

std::string figure_words(double figure, const std::string& unit) {
    if (!std::isfinite(figure)) return {};
    return format_number(figure, 3) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

Json findings_json(const std::vector<Finding>& findings) {
    Json list = Json::array();
    for (const Finding& finding : findings) {
        Json entry{{"id", finding.check},
                   {"level", to_string(finding.level)},
                   {"subject", finding.subject},
                   {"source", finding.source},
                   {"sentence", finding.sentence},
                   {"way_out", finding.way_out}};
        if (std::isfinite(finding.figure)) entry["figure"] = finding.figure;
        if (std::isfinite(finding.threshold)) entry["threshold"] = finding.threshold;
        if (!finding.unit.empty()) entry["unit"] = finding.unit;
        list.push_back(std::move(entry));
    }
    return list;
}

Section findings_section(const std::vector<Finding>& findings) {
    Table table{"What the model takes for granted, and what was found of it.",
                {{"Check"}, {"State"}, {"Found"}, {"Figure"}, {"Threshold"}, {"Threshold from"}},
                {}};
    for (const CheckLevel level : worst_first)
        for (const Finding& finding : of_level(findings, level))
            table.rows.push_back({finding.check, to_string(level), finding_words(finding),
                                  figure_words(finding.figure, finding.unit),
                                  figure_words(finding.threshold, finding.unit), finding.source});
    return {"Checks", {table}};
}

std::string finding_words(const Finding& finding) {
    return finding.way_out.empty() ? finding.sentence : finding.sentence + "; " + finding.way_out;
}

std::vector<std::string> untold(const std::vector<Finding>& findings) {
    std::vector<std::string> sentences;
    for (const CheckLevel level : {CheckLevel::wrong, CheckLevel::doubtful})
        for (const Finding& finding : of_level(findings, level))
            if (!finding.told) sentences.push_back(finding_words(finding));
    return sentences;
}

std::string findings_line(const std::vector<Finding>& findings) {
    std::vector<std::string> parts;
    for (const CheckLevel level : {CheckLevel::fine, CheckLevel::doubtful, CheckLevel::wrong}) {
        const std::vector<Finding> own = of_level(findings, level);
        if (own.empty()) continue;
        std::vector<std::string> names;
        for (const Finding& finding : own)
            if (level != CheckLevel::fine && std::find(names.begin(), names.end(), finding.check) == names.end())
                names.push_back(finding.check);
        parts.push_back(std::to_string(own.size()) + " " + to_string(level) +
                        (names.empty() ? "" : " (" + join(names, ", ") + ")"));
    }
    return "checks: " + join(parts, ", ");
}

}  // namespace myo
