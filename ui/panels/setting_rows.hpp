#pragma once

#include <string>
#include <vector>

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// A number of the settings and how it is edited.
struct SettingField {
    NumberField field;
    double commands::Settings::*value;
};
/// A row for each; a change becomes a command.
void setting_rows(PanelContext& context, const std::vector<SettingField>& fields, OpenEdit& edit);

/// A list for one of the settings' ids.
void setting_choice(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip,
                    const std::vector<commands::Choice>& choices, std::string commands::Settings::*id);

}  // namespace myo::ui::panels
