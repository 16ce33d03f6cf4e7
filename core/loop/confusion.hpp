#pragma once

#include "loop/diagnosis.hpp"

namespace myo {

/// Names the candidates that explain the residual in the same way, as foretold or as fitted, and what would tell them apart.
void find_confusions(Diagnosis& diagnosis);

}  // namespace myo
