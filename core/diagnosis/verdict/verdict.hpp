#pragma once

#include <string>

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// Sets the verdict by the first of verdict_rules() that applies, and gives the fit it stands on: the declared one,
/// that of the asserted effects, or the best attempt where nothing explains the residual.
JudgedFit decide(Diagnosis& diagnosis);

/// What a person must know where extrapolation may leave more than the noise: how much, of what, and which is to be
/// finer.
std::string above_noise_note(const NumericalError& numerics, double noise_m);

/// Once the numerical error of the fit that asserted effects stand on, `augmented`, has been found with it: the
/// verdict, and the fit among the candidates or pairs, are that one's.
void take_over_corrected(Diagnosis& diagnosis);

/// Halves the confidence, and says why, where the trials that took no part are predicted worse with the verdict's
/// effects than without, `before` and `after` being known. The answer stands as it was: these trials choose nothing.
void discount_worse_predictions(Diagnosis& diagnosis);

}  // namespace myo::diagnosis
