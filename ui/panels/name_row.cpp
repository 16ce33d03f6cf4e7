#include "panels/name_row.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

namespace myo::ui::panels {

bool NameEdit::row(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip,
                   std::string& value) {
    row_label(context.theme, label, tip);
    // The typed text is kept apart from the value, which changes only when the field is left.
    std::string text = field_ == name ? typed_ : value;
    if (ImGui::InputText(("##" + name).c_str(), &text)) field_ = name, typed_ = text;
    context.items.mark(name);
    tooltip(context.theme, tip);
    const bool changed = ImGui::IsItemDeactivatedAfterEdit() && text != value;
    if (!ImGui::IsItemActive() && field_ == name) field_.clear();
    if (changed) value = text;
    return changed;
}

}  // namespace myo::ui::panels
