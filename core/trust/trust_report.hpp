#pragma once

#include <string>
#include <vector>

#include "report/html_report.hpp"
#include "trust/trust_summary.hpp"

namespace myo {

/// One page: rates with their bounds, confusion matrix, reliability, parameters, the cases that went wrong.
HtmlReport trust_report(const std::vector<CaseRecord>& records, const std::string& command_line);

/// Share of right answers over stated confidence, with 90 % intervals, beside the diagonal of perfect calibration.
std::string reliability_figure(const TrustSummary& summary);

}  // namespace myo
