#include "panels/escape.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace myo::ui::panels {

bool escape_closes() {
    if (!ImGui::IsKeyPressed(ImGuiKey_Escape, false) || ImGui::GetIO().WantTextInput) return false;
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    if (g.OpenPopupStack.Size > g.BeginPopupStack.Size) return false;  // a popup lies above
    // ImGui closes lists and menus at the start of the frame: then the key has been used.
    const auto is_open = [&](const ImGuiWindow* window) {
        return std::any_of(g.OpenPopupStack.begin(), g.OpenPopupStack.end(),
                           [&](const ImGuiPopupData& popup) { return popup.Window == window; });
    };
    return std::none_of(g.Windows.begin(), g.Windows.end(), [&](const ImGuiWindow* window) {
        return (window->Flags & ImGuiWindowFlags_Popup) != 0 && window->WasActive && !window->Active &&
               !is_open(window);
    });
}

bool keys_belong_to_popup() {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    return g.OpenPopupStack.Size > 0 || std::any_of(g.Windows.begin(), g.Windows.end(), [](const ImGuiWindow* window) {
               return (window->Flags & ImGuiWindowFlags_Popup) != 0 && (window->WasActive || window->Active);
           });
}

}  // namespace myo::ui::panels
