#pragma once

#include "diagnosis/diagnosis_work.hpp"

namespace myo::diagnosis {

/// The first part of a diagnosis: the data, the step, the declared fit and the numerical error at it.
///
/// False: cancelled, or work.result.failure says why the declared model cannot be fitted.
bool fit_declared(DiagnosisWork& work);

}  // namespace myo::diagnosis
