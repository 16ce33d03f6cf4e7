#pragma once

#include <string>
#include <vector>

#include "report/html_report.hpp"
#include "validation/validation_summary.hpp"

namespace myo::validation {

/// One page: rates with their bounds, confusion matrix, reliability, parameters, the cases that went wrong.
report::HtmlReport validation_report(const std::vector<CaseRecord>& records, const std::string& command_line);

/// Share of right answers over stated confidence, with 90 % intervals, beside the diagonal of perfect calibration.
std::string reliability_figure(const ValidationSummary& summary);

}  // namespace myo::validation
