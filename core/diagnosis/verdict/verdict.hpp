#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// Output of the verdict phase.
struct Decision {
    Verdict verdict;
    /// Fit that it rests on: that of the declared model, that of the named effects, or the best attempt if nothing
    /// explains the residual.
    JudgedFit fit;
    std::vector<std::string> notes;
};

/// The verdict by the first of verdict_rules() that applies, with its ranking.
/// @param diagnosis  with ranked candidates and sets; its verdict is not used
Decision decide(const Diagnosis& diagnosis);

/// Note for the case that extrapolation may leave more than the noise: size and cause of the error, and the remedy.
std::string above_noise_note(const NumericalError& numerics, double noise_m);

/// The diagnosis with the values of the verdict, and the fit among candidates or sets, taken from the final fit
/// `augmented`, whose own numerical error is removed. Unchanged unless the verdict names effects.
Diagnosis with_final_fit(Diagnosis diagnosis);

/// The diagnosis with a reduced confidence (VerdictPolicy::contradicted) and a note if the trials that took no part are
/// predicted worse with the effects of the verdict than without. Requires `before` and `after`. The verdict stays:
/// these trials choose nothing.
Diagnosis with_tested_confidence(Diagnosis diagnosis);

}  // namespace myo::diagnosis
