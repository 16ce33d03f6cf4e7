#pragma once

#include "check/finding.hpp"

namespace myo::check {

/// Level of a step by its relative frequency error, for a modulus that is fitted on that vibration: the error of the
/// modulus is twice as large, as the modulus scales with the squared frequency.
CheckLevel step_level(double frequency_error);

}  // namespace myo::check
