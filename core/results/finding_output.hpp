#pragma once

#include <string>
#include <vector>

#include "check/finding.hpp"
#include "report/html_report.hpp"
#include "report/json.hpp"

namespace myo::results {

/// JSON array of all findings.
///
/// @return  [{"id", "level": "green" | "amber" | "red", "subject", "figure", "threshold", "unit", "source", "sentence",
///          "way_out"}]; figure, threshold and unit only if the check has them
report::Json findings_json(const std::vector<check::Finding>& findings);

/// Table of all findings, worst first.
report::Section findings_section(const std::vector<check::Finding>& findings);

/// Sentence of a finding with its remedy.
std::string finding_words(const check::Finding& finding);

/// Sentences of violated and doubtful findings that no other warning states, worst first.
/// For the list of warnings of a page; findings that were already reported as warnings have `warned` set.
std::vector<std::string> sentences_to_report(const std::vector<check::Finding>& findings);

/// One-line summary: "checks: 11 green, 1 amber (step), 1 red (start)".
std::string findings_line(const std::vector<check::Finding>& findings);

}  // namespace myo::results
