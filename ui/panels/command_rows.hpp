#pragma once

#include "panels/actuator_edits.hpp"
#include "panels/number_field.hpp"

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

/// Rows for the command of a chamber or tendon in the shown trial: none, constant, from t = 0 on, a curve, or a column
/// of the trial's actuation file, which is shown but not edited. Draws nothing without a trial. Emits EditDeclaration.
///
/// @param name  item name for tests, to which "/kind" and "/value" are added
void command_rows(PanelContext& context, const DeclaredActuator& actuator, const CommandField& field,
                  const std::string& name, NumberEdits& edits);

}  // namespace myo::ui::panels
