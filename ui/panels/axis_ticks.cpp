#include "panels/axis_ticks.hpp"

#include <imgui.h>

#include "panels/declared_list.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// TOML list of the ticked axes.
std::string list_text(const std::array<bool, 3>& ticked) {
    std::string text;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (ticked[axis]) text += (text.empty() ? "" : ", ") + toml::toml_text(axis_names[axis]);
    return "[" + text + "]";
}

}  // namespace

void axis_ticks(PanelContext& context, const char* label, const char* tip, const std::array<bool, 3>& ticked,
                const toml::TomlPath& key, const std::string& item) {
    row_label(context.theme, label, tip);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<bool, 3> after = ticked;
        if (axis > 0) ImGui::SameLine();
        const std::string name = axis_names[axis];
        if (ImGui::Checkbox((name + "##" + item).c_str(), &after[axis])) {
            // All axes are what holds without the key, so the key is removed.
            const bool all = after[0] && after[1] && after[2];
            const commands::DeclarationEdit edit = all ? commands::DeclarationEdit(commands::RemoveDeclared{key})
                                                       : commands::DeclarationEdit(
                                                             commands::SetDeclared{key, list_text(after)});
            context.emit(commands::EditDeclaration{{edit}, item + "/" + name});
        }
        context.items.mark(item + "/" + name);
    }
}

}  // namespace myo::ui::panels
