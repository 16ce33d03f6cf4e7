#pragma once

#include "loop/diagnosis.hpp"

namespace myo {

/// Sets the verdict from the tests and fits, and gives the fit it stands on: the declared one, that of the asserted effects, or the best
/// attempt where nothing explains the residual.
JudgedFit decide(Diagnosis& diagnosis);

/// Takes effects back with which the trials that took no part are predicted worse than without, `before` and `after` being known: what is missing
/// is something else. These trials refuse an answer here; they never choose one.
void refute(Diagnosis& diagnosis);

}  // namespace myo
