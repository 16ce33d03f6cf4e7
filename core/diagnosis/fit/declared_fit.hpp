#pragma once

#include "diagnosis/diagnosis_work.hpp"

namespace myo::diagnosis {

/// First phase of a diagnosis: chooses data and time steps, fits the declared model, and computes the numerical error
/// of that fit.
///
/// Returns false if cancelled, or if the declared model cannot be fitted (reason in work.result.failure).
bool fit_declared(DiagnosisWork& work);

}  // namespace myo::diagnosis
