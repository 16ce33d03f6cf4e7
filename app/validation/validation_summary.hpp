#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/case_record.hpp"
#include "validation/proportion.hpp"
#include "validation/set_summary.hpp"

namespace myo::validation {

/// Cases with a stated confidence in a range, and the share of right answers.
struct ConfidenceBin {
    double from = 0.0, to = 1.0;
    double mean = 0.0;  // mean stated confidence; NaN if empty
    Proportion right;
};

/// Accuracy of one parameter over all cases whose effect was named correctly.
struct ParameterQuality {
    std::string effect, parameter;
    double median = 0.0;  // relative error; distance [m] for positions
    bool is_place = false;
    Proportion good;  // within 10 %, positions within 5 mm
};

/// Result of a validation of the diagnosis.
struct ValidationSummary {
    int cases = 0, failed = 0;
    // Cases per body, "beam with muscles" apart from "beam".
    std::map<std::string, int> families;
    Proportion top_1, top_2;  // over all cases with one effect, which the diagnosis knows
    /// Shares of the cases with a known effect in which no other effect is declared indistinguishable from the truth.
    Proportion separable_top_1, separable_top_2;
    Proportion in_group;            // right, or an effect declared indistinguishable from the truth
    Proportion false_alarms;        // cases without effect: an effect, or `unknown`
    Proportion missed;              // cases with effect: `none`
    Proportion unknown;             // cases with a deleted effect
    Proportion mimicked;            // of these: another effect predicts the held-out trial within 1.3 noise levels
    Proportion unknown_unmimicked;  // `unknown` among the deleted ones that are not mimicked
    Proportion parameters_good;     // of all parameters of correctly named effects
    std::vector<ParameterQuality> parameters;
    SetSummary sets;
    /// truth -> answer -> count; a deleted effect as "(id)", two effects as "a + b".
    std::map<std::string, std::map<std::string, int>> confusion;
    std::vector<ConfidenceBin> reliability;
    double calibration_error = 0.0;  // mean distance of confidence and share of right answers, weighted by bin size
    double validation_before = 0.0,
           validation_after = 0.0;  // medians over cases with a correctly named effect, in noise levels
    double median_diagnose_s = 0.0, longest_diagnose_s = 0.0, median_make_s = 0.0;
};
/// Statistics over all records; failed cases count in no rate. Shares of nothing are NaN.
ValidationSummary validation_summary(const std::vector<CaseRecord>& records);

/// Text for a terminal.
std::string summary_text(const ValidationSummary& summary);

/// Numbers of the summary as JSON, rates with count, share and both bounds.
report::Json summary_json(const ValidationSummary& summary);

}  // namespace myo::validation
