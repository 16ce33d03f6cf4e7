#pragma once

#include <string>
#include <vector>

#include "report/html_report.hpp"
#include "validation/validation_summary.hpp"

namespace myo::validation {

/// HTML report: rates with bounds, confusion matrix, reliability diagram, parameters, wrong cases.
///
/// @param command_line  printed in the report, so that it can be repeated
report::HtmlReport validation_report(const std::vector<CaseRecord>& records, const std::string& command_line);

/// Reliability diagram as SVG: share of right answers over stated confidence, with 90 % intervals and the diagonal of
/// perfect calibration.
std::string reliability_figure(const ValidationSummary& summary);

}  // namespace myo::validation
