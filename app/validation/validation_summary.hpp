#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/case_record.hpp"
#include "validation/proportion.hpp"

namespace myo::validation {

/// Cases whose stated confidence was in a range, and how many of their answers were right.
struct ConfidenceBin {
    double from = 0.0, to = 1.0;
    double mean = 0.0;  // of the stated ones; NaN of none
    Proportion right;
};

/// How well one parameter was found, over all cases whose effect was named rightly.
struct ParameterQuality {
    std::string effect, parameter;
    double median = 0.0;  // relative error; of places the distance [m]
    bool is_place = false;
    Proportion good;  // within 10 %, places within 5 mm
};

/// What a trust study found.
struct ValidationSummary {
    int cases = 0, failed = 0;
    std::map<std::string, int> families;
    Proportion top_1, top_2;                      // over all cases with an effect that the diagnosis knows
    Proportion separable_top_1, separable_top_2;  // of these, where no other effect is said to look like the truth
    Proportion in_group;      // answered right, or with one said not to be told apart from the truth
    Proportion false_alarms;  // over cases without an effect: an effect, or `unknown`
    Proportion missed;        // over cases with an effect: `none`
    Proportion unknown;       // over cases whose effect was deleted
    Proportion mimicked;      // of the deleted: another effect that predicts the held-out trial within 1.3 noise levels
    Proportion unknown_unmimicked;  // over the deleted less those: what the experiment, its unused trial included,
                                    // speaks against
    Proportion parameters_good;     // of all parameters of effects named rightly
    std::vector<ParameterQuality> parameters;
    /// truth -> answer -> count; a deleted effect as "(its id)", two effects as "a + b".
    std::map<std::string, std::map<std::string, int>> confusion;
    std::vector<ConfidenceBin> reliability;
    double calibration_error = 0.0;  // mean distance of confidence and share right, over bins by their cases
    double validation_before = 0.0,
           validation_after = 0.0;  // medians over cases with an effect named rightly, in noise levels
    double median_diagnose_s = 0.0, longest_diagnose_s = 0.0, median_make_s = 0.0;
};
ValidationSummary validation_summary(const std::vector<CaseRecord>& records);

/// As a person reads it in a terminal.
std::string summary_text(const ValidationSummary& summary);

report::Json summary_json(const ValidationSummary& summary);

}  // namespace myo::validation
