#pragma once

#include <vector>

#include "loop/force_fields.hpp"
#include "loop/missing_force.hpp"

namespace myo {

/// What a mode's amplitude goes with, strongest first: position, velocity, |v| v and acceleration of the body along the pattern, the rate at
/// which the material's own force along it changes (strain rate), the muscles' activation, and time.
///
/// @param trace  of the trial with the force
std::vector<Correlate> course_correlates(const Study& study, const Affected& trial, const Trace& trace, const KnotTimes& knots, const ForceMode& mode);

}  // namespace myo
