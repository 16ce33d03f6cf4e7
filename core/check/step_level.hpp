#pragma once

#include "check/finding.hpp"

namespace myo::check {

/// What a step's relative frequency error means for a modulus that is fitted on that vibration.
CheckLevel step_level(double frequency_error);

}  // namespace myo::check
