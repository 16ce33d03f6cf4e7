#pragma once

#include "diagnosis/diagnosis_work.hpp"

namespace myo::diagnosis {

/// Fits a second effect together with the best one if that leaves an excess, and then refits each of the two alone to
/// test whether the other is needed.
void search_pairs(DiagnosisWork& work);

}  // namespace myo::diagnosis
