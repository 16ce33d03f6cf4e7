#pragma once

#include <string>
#include <vector>

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// A number in the settings and how it is edited.
struct SettingField {
    NumberField field;                  // label, unit, limits
    double commands::Settings::*value;  // the member that it edits
};
/// Draws a row for each field. A change is emitted as ChangeSettings.
///
/// @param edit  edits in progress, kept by the panel between frames
void setting_rows(PanelContext& context, const std::vector<SettingField>& fields, NumberEdits& edit);

/// Draws a list for one of the ids in the settings. A change is emitted as ChangeSettings.
///
/// @param name  item name for tests, and name of the edit for undo
void setting_choice(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip,
                    const std::vector<commands::Choice>& choices, std::string commands::Settings::*id);

}  // namespace myo::ui::panels
