#pragma once

#include <vector>

#include "panels/actions.hpp"

namespace myo::ui::panels {

/// Menu Help: the parts of the help, the palette, version and licences.
void add_help_actions(std::vector<Action>& all);

}  // namespace myo::ui::panels
