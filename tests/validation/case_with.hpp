#pragma once

#include <string>
#include <vector>

#include "validation/case_record.hpp"

namespace myo::validation {

/// Record of a beam with this truth and answer.
inline CaseRecord case_with(CaseKind kind, const std::string& truth, const std::vector<std::string>& answer) {
    CaseRecord record;
    record.kind = kind;
    record.family = "beam";
    record.truth = truth;
    record.answer = answer;
    return record;
}

}  // namespace myo::validation
