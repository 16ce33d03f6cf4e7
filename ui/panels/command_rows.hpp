#pragma once

#include "panels/actuator_edits.hpp"
#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Rows for the command of a chamber or tendon in the shown trial: none, constant, from t = 0 on, a curve, or a column
/// of the trial's actuation file, which is shown but not edited. Draws nothing without a trial. Emits EditDeclaration.
///
/// @param name  item name for tests, to which "/kind" and "/value" are added
void command_rows(PanelContext& context, const DeclaredActuator& actuator, const std::string& name, NumberEdits& edits);

}  // namespace myo::ui::panels
