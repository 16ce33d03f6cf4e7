#pragma once

#include "loop/diagnosis.hpp"

namespace myo {

/// Names the candidates whose parts of the residual point the same way, and what would tell them apart.
void find_confusions(const Study& study, Diagnosis& diagnosis);

}  // namespace myo
