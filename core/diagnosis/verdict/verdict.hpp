#pragma once

#include <string>

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// Sets the verdict by the first of verdict_rules() that applies. Returns the fit it rests on: that of the declared
/// model, that of the named effects, or the best attempt if nothing explains the residual.
JudgedFit decide(Diagnosis& diagnosis);

/// Note for the case that extrapolation may leave more than the noise: size and cause of the error, and the remedy.
std::string above_noise_note(const NumericalError& numerics, double noise_m);

/// Takes over the final fit `augmented`, whose own numerical error is removed, for the values of the verdict and for
/// the fit among candidates or pairs. Does nothing unless the verdict names effects.
void take_over_corrected(Diagnosis& diagnosis);

/// Halves the confidence, and adds a note, if the trials that took no part are predicted worse with the effects of the
/// verdict than without. Requires `before` and `after`. The verdict stays: these trials choose nothing.
void discount_worse_predictions(Diagnosis& diagnosis);

}  // namespace myo::diagnosis
