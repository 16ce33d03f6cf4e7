#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Draws the question that the workbench has to ask before it continues, if any: what to do with recovered work, the
/// unit of a mesh file, where the experiment of a project is, unsaved changes, or a running job when the window closes.
void draw_questions(PanelContext& context);

}  // namespace myo::ui::panels
