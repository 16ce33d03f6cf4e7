#pragma once

#include <memory>
#include <vector>

#include "panels/actions.hpp"

namespace myo::ui::panels {

/// Actions on what is there now: examples and files to open, trials and panels to show, quantities that colour the
/// body.
std::vector<Action> offered_actions(const commands::WorkbenchState& state, const commands::Backend& backend,
                                    const std::vector<std::unique_ptr<Panel>>& panels);

}  // namespace myo::ui::panels
