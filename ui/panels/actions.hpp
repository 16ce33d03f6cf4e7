#pragma once

#include <functional>
#include <string>
#include <vector>

#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// Keys that are pressed together.
struct Shortcut {
    int key = -1;  // ImGuiKey or ExtraKey; -1: none
    bool ctrl = false;
    bool shift = false;
    const char* label = "";  // "Ctrl+S"
};

/// Something a person can ask for by menu, by keys and by the command palette alike.
struct Action {
    std::string id;     // "file.save"
    std::string menu;   // "File"
    std::string label;  // "Save"
    Shortcut shortcut;
    std::function<void(PanelContext&, viewport::ViewportState&)> perform;
    std::function<bool(const commands::WorkbenchState&)> enabled = {};  // empty: always
    std::function<bool(const commands::WorkbenchState&)> checked = {};  // empty: it is no switch
    bool separated = false;                                             // a line above it in the menu
};

/// All of them, menus in their order.
const std::vector<Action>& all_actions();

/// Performs what the keys of this frame ask for.
void react_to_shortcuts(PanelContext& context, viewport::ViewportState& viewport);

}  // namespace myo::ui::panels
