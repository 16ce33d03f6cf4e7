#pragma once

#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// Signal a(t) of a muscle in the shown trial: that of the muscle it follows, scaled; its own; the trial's recording;
/// otherwise passive, a = 1.
fibre::Signal signal_of(const WorkbenchState& state, const Muscle& muscle);

}  // namespace myo::ui::commands
