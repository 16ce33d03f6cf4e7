#pragma once

#include <vector>

#include "planning/trial_family.hpp"

namespace myo::planning {

/// Durations of the trials of a family [s].
struct TrialDurations {
    double usual_s = 0.0, long_s = 0.0;
};

/// For each actuator a step, a smaller one, a slow ramp, a faster sine and, in experiments with holds, the body at
/// rest, over the range seen in the trials or up to a declared limit. The other actuators rest.
///
/// @param limits  of the actuators' kinds; an actuator that never acted and has no limit is left out, and so are
/// muscles that follow another or a signal of their own
/// @return        names and keys as trial_family() returns them, not yet unique in the experiment
std::vector<PossibleTrial> actuator_trials(const setup::Setup& setup, const experiment::LimitsDeclaration& limits,
                                           const TrialDurations& durations, const FamilyPolicy& policy);

}  // namespace myo::planning
