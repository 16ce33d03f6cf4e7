#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// What the workbench wants to know before it goes on: the unit of a mesh, what is to become of unsaved changes, and of
/// work that was found unsaved.
void draw_questions(PanelContext& context);

}  // namespace myo::ui::panels
