#pragma once

#include <vector>

#include "diagnosis/missing_force/force_fields.hpp"
#include "diagnosis/missing_force/missing_force.hpp"

namespace myo::diagnosis {

/// What a mode's amplitude goes with, strongest first: position, velocity, |v| v and acceleration of the body along the
/// pattern, the rate at which the material's own force along it changes (strain rate), the muscles' activation, and
/// time.
///
/// @param trace  of the trial with the force
std::vector<statistics::Correlate> course_correlates(const setup::Setup& setup, const effect::Affected& trial,
                                                     const dynamics::Trace& trace, const KnotTimes& knots,
                                                     const ForceMode& mode);

}  // namespace myo::diagnosis
