#pragma once

#include <string>

#include "commands/units.hpp"
#include "panels/actuator_edits.hpp"

namespace myo::ui::panels {

/// How the command of an actuator is shown.
struct CommandField {
    commands::Dimension dimension = commands::Dimension::number;  // of the value, for units that are typed
    std::string unit;                                             // shown
    std::string quantity;                                         // "Pressure"
    commands::Limits limits{0.0, 1.0};                            // of the value, SI
    double smallest_step = 0.1;                                   // per pixel of dragging, in the shown unit
    double usual = 0.0;                                           // where a command is new, SI
};

/// The field of the quantity that an actuator's command is.
const CommandField& command_field(const DeclaredActuator& actuator);

}  // namespace myo::ui::panels
