#pragma once

#include <string>

#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// Title of the window: a dot while something is unsaved, what is open, and the program's name: "• beam – Myoloop".
std::string window_title(const WorkbenchState& state);

}  // namespace myo::ui::commands
