#pragma once

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Lists the chambers and tendons of the body in their colours, with their commands at the shown time. Draws nothing
/// for a body without them. Item names begin with "fibres/actuator/".
void draw_actuators(PanelContext& context);

}  // namespace myo::ui::panels
