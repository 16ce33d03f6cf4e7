#pragma once

#include <vector>

#include "panels/actions.hpp"

namespace myo::ui::panels {

/// Entries of the menu File that take work away: a project with its files, a copy of the experiment, the body.
void add_export_actions(std::vector<Action>& all);

}  // namespace myo::ui::panels
