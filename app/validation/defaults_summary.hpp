#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/html_report.hpp"
#include "validation/defaults_record.hpp"
#include "validation/proportion.hpp"

namespace myo::validation {

/// What a study of the defaults found.
struct DefaultsSummary {
    int cases = 0;
    std::map<DefaultsAnswer, int> answers;
    Proportion right;         // right numbers or the true cause named, of all cases that were answered
    Proportion silent;        // wrong without a word, likewise
    Proportion false_alarms;  // remarks where nothing is amiss and the numbers are right, of cases without a slip
    std::map<std::string, Proportion> by_slip, by_shape;  // right; "none": without a slip
    Proportion half_interval_right;  // of cases without a slip, numbers with half a sampling interval as step
    std::map<std::string, double> normalised_rms;  // by number: errors over deviations, cases without a slip
    /// Times of fits over those with half a sampling interval, where the latter's numbers were right.
    double median_time_ratio = 0.0;
    Proportion twice_the_time_at_most;
    double median_fit_s = 0.0, longest_fit_s = 0.0, median_make_s = 0.0;
};
DefaultsSummary defaults_summary(const std::vector<DefaultsRecord>& records);

/// "   7 bar    held_on_a_line       cause named   E +0.31 ± 0.05 %, damping ...  support": a line of a terminal.
std::string record_line(const DefaultsRecord& record);

/// As a person reads it in a terminal.
std::string summary_text(const DefaultsSummary& summary);

report::Json summary_json(const DefaultsSummary& summary);

/// One page: the rates, the slips, the cases that were not right.
report::HtmlReport defaults_report(const std::vector<DefaultsRecord>& records, const std::string& command_line);

}  // namespace myo::validation
