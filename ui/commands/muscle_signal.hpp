#pragma once

#include "commands/workbench_state.hpp"

namespace myo {

/// a(t) of a muscle in a trial: its own, its partner's share, what the trial recorded, or passive.
Signal signal_of(const WorkbenchState& state, const Muscle& muscle);

}  // namespace myo
