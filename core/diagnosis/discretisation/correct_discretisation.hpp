#pragma once

#include "diagnosis/diagnosis_work.hpp"

namespace myo::diagnosis {

/// The numerical error at a fit, and the fit with it taken off; again while that takes the fit elsewhere: an error of
/// another motion is another error. The first one found also gives the cells the modulus with which they move like
/// finer ones.
///
/// work.result.data.shift is then this fit's. False: cancelled.
bool correct_discretisation(DiagnosisWork& work, JudgedFit& judged_fit, const std::string& stage,
                            const ErrorCorrection& settling);

/// Finds the numerical error of the trials that a fit did not see.
void add_error_of_other_trials(DiagnosisWork& work, JudgedFit& judged_fit);

}  // namespace myo::diagnosis
