#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/html_report.hpp"
#include "validation/defaults_record.hpp"
#include "validation/proportion.hpp"

namespace myo::validation {

/// Result of a validation of the defaults.
struct DefaultsSummary {
    int cases = 0;
    std::map<DefaultsAnswer, int> answers;
    Proportion right;         // right numbers or the true cause named, of all cases with a truth
    Proportion silent;        // wrong without any remark, of all cases with a truth
    Proportion false_alarms;  // of cases with a correct declaration
    /// Right answers by declaration error and by body; key "none": correct declaration.
    std::map<std::string, Proportion> by_slip, by_shape;
    /// Right numbers with informative deviations (DefaultsJudgement::max_deviation) with half a sampling interval as
    /// step, of cases with a correct declaration.
    Proportion half_interval_right;
    /// Per parameter: rms of error over standard deviation, cases with a correct declaration. One if the stated
    /// deviations are realistic.
    std::map<std::string, double> normalised_rms;
    /// Time of a fit over that with half a sampling interval, where the latter was right.
    double median_time_ratio = 0.0;
    Proportion twice_the_time_at_most;
    double median_fit_s = 0.0, longest_fit_s = 0.0, median_make_s = 0.0;
};
/// Statistics over all records; failed cases without a truth are skipped.
DefaultsSummary defaults_summary(const std::vector<DefaultsRecord>& records);

/// Line of a terminal: "   7 bar    held_on_a_line       cause named   E +0.31 ± 0.05 %, damping ...  support".
std::string record_line(const DefaultsRecord& record);

/// Text for a terminal.
std::string summary_text(const DefaultsSummary& summary);

/// Numbers of the summary as JSON, rates with count, share and both bounds; times in s.
report::Json summary_json(const DefaultsSummary& summary);

/// HTML report: rates, declaration errors, and the cases that were not right.
///
/// @param command_line  printed in the report, so that it can be repeated
report::HtmlReport defaults_report(const std::vector<DefaultsRecord>& records, const std::string& command_line);

}  // namespace myo::validation
