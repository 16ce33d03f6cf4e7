#include "panels/setting_rows.hpp"

namespace myo::ui::panels {

void setting_rows(PanelContext& context, const std::vector<SettingField>& fields, NumberEdits& edit) {
    for (const SettingField& entry : fields) {
        // A copy per row: it differs from the state in this one number only.
        commands::Settings settings = context.state.settings;
        bool goes_on = false;
        if (number_row(context, entry.field, edit, settings.*entry.value, goes_on))
            context.emit(commands::ChangeSettings{settings, entry.field.name, goes_on});
    }
}

// The item name also names the edit for undo.
void setting_choice(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip,
                    const std::vector<commands::Choice>& choices, std::string commands::Settings::*id) {
    commands::Settings settings = context.state.settings;
    if (choice_row(context, label, name, tip, choices, settings.*id))
        context.emit(commands::ChangeSettings{settings, name, false});
}

}  // namespace myo::ui::panels
