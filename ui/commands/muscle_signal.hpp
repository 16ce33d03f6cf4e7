#pragma once

#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// a(t) of a muscle in a trial: its own, its partner's share, what the trial recorded, or passive.
fibre::Signal signal_of(const WorkbenchState& state, const Muscle& muscle);

}  // namespace myo::ui::commands
