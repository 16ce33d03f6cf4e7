#pragma once

#include "diagnosis/diagnosis_work.hpp"

namespace myo::diagnosis {

/// Computes the numerical error at a fit and refits with the error removed; repeats while the fit changes, because the
/// error depends on the motion. The first call also sets the effective modulus of the cells.
///
/// On return work.result.data.shift belongs to this fit. Returns false if cancelled.
bool correct_discretisation(DiagnosisWork& work, JudgedFit& judged_fit, const std::string& stage,
                            const ErrorCorrection& settling);

/// Adds the numerical error of the trials that were not used in the fit.
void add_error_of_other_trials(DiagnosisWork& work, JudgedFit& judged_fit);

}  // namespace myo::diagnosis
