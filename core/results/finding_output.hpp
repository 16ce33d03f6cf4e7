#pragma once

#include <string>
#include <vector>

#include "check/finding.hpp"
#include "report/html_report.hpp"
#include "report/json.hpp"

namespace myo::results {

/// [{"id", "level": "green" | "amber" | "red", "subject", "figure", "threshold", "unit", "source", "sentence",
/// "way_out"}]; figure, threshold and unit where a check has one.
report::Json findings_json(const std::vector<check::Finding>& findings);

/// A table of all findings, the worst first.
report::Section findings_section(const std::vector<check::Finding>& findings);

/// The sentence with the way out: for a person, of what is not fine.
std::string finding_words(const check::Finding& finding);

/// Sentences of the findings that no warning has told a person of, the worst first.
std::vector<std::string> untold(const std::vector<check::Finding>& findings);

/// "checks: 11 green, 1 amber (step), 1 red (start)"
std::string findings_line(const std::vector<check::Finding>& findings);

}  // namespace myo::results
