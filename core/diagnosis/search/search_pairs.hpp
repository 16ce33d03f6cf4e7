#pragma once

#include "diagnosis/diagnosis_work.hpp"

namespace myo::diagnosis {

/// Where the best effect leaves something, a second beside it, and each of the two is asked whether it is still needed.
void search_pairs(DiagnosisWork& work);

}  // namespace myo::diagnosis
