#pragma once

#include <vector>

#include "diagnosis/missing_force/force_fields.hpp"
#include "diagnosis/missing_force/missing_force.hpp"

namespace myo::diagnosis {

/// Quantities that correlate with the amplitude of a mode, strongest first: position, velocity, |v| v and acceleration
/// of the body along the pattern, rate of the elastic force along the pattern (strain rate), activation of the muscles,
/// and time.
/// @param trace  of the trial with the force; fewer than two steps: no correlates
std::vector<statistics::Correlate> course_correlates(const setup::Setup& setup, const effect::Affected& trial,
                                                     const dynamics::Trace& trace, const KnotTimes& knots,
                                                     const ForceMode& mode, const MissingForcePolicy& policy);

}  // namespace myo::diagnosis
