#pragma once

#include "diagnosis/diagnosis_work.hpp"

namespace myo::diagnosis {

/// How far a fit with the numerical error taken off goes, and how far it may go from the one before without the error
/// being found anew, in units of the noise.
struct Settling {
    Effort effort;
    double change = 0.0;
};
inline constexpr Settling settled_declared{{12}, 1.0}, settled_effect{{20}, 3.0};

/// The numerical error at a fit, and the fit with it taken off; again while that takes the fit elsewhere: an error of
/// another motion is another error. The first one found also gives the cells the modulus with which they move like
/// finer ones.
///
/// work.result.data.shift is then this fit's. False: cancelled.
bool settle(DiagnosisWork& work, JudgedFit& judged_fit, const std::string& stage, const Settling& settling);

/// Finds the numerical error of the trials that a fit did not see.
void foretell_error(DiagnosisWork& work, JudgedFit& judged_fit);

}  // namespace myo::diagnosis
