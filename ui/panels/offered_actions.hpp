#pragma once

#include <memory>
#include <vector>

#include "panels/actions.hpp"

namespace myo::ui::panels {

/// Actions that depend on the present state: examples and recent files to open, trials and panels to show, fields that
/// colour the body. The palette lists them after all_actions(). Created again in each frame in which the palette is
/// open.
std::vector<Action> offered_actions(const commands::WorkbenchState& state, const commands::Backend& backend,
                                    const std::vector<std::unique_ptr<Panel>>& panels);

}  // namespace myo::ui::panels
