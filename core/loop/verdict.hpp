#pragma once

#include "loop/diagnosis.hpp"

namespace myo {

/// Sets the verdict from the tests and fits, and gives the fit it stands on: the declared one, that of the asserted effects, or the best
/// attempt where nothing explains the residual.
JudgedFit decide(Diagnosis& diagnosis);

}  // namespace myo
