#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/case_record.hpp"
#include "validation/proportion.hpp"

namespace myo::validation {

/// How well sets of effects are found, over the cases without an effect and those whose effects the diagnosis knows.
struct SetSummary {
    std::map<int, Proportion> exact;  // answers that are the whole truth, by the number of effects that act
    Proportion precision;             // asserted effects that act
    Proportion recall;                // acting effects that are asserted
    Proportion false_inclusion;       // cases with an asserted effect that does not act
    Proportion covered;               // true numbers of asserted effects within their 95 % intervals
    /// Stated probabilities that an effect acts, those that leave it open: mean distance between probability and share
    /// that acts, over bins of equal count.
    int open_probabilities = 0;
    double probability_error = 0.0;  // NaN if there is none
};
SetSummary set_summary(const std::vector<CaseRecord>& records);

/// A share of the summary with its name.
struct NamedShare {
    std::string name;
    Proportion share;
    bool is_fault = false;  // small is good: its upper bound is stated
};
/// In the order of a table.
std::vector<NamedShare> set_proportions(const SetSummary& summary);
/// Lines of a terminal.
std::string set_summary_text(const SetSummary& summary);
report::Json set_summary_json(const SetSummary& summary);

}  // namespace myo::validation
