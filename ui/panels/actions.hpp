#pragma once

#include <functional>
#include <string>
#include <vector>

#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// A keyboard shortcut.
struct Shortcut {
    int key = -1;            // ImGuiKey or ExtraKey; -1: none
    bool ctrl = false;       // Ctrl has to be held; otherwise it must not be
    bool shift = false;      // as ctrl
    const char* label = "";  // shown in menus and the palette: "Ctrl+S"
};

/// An action that is available in a menu, by a shortcut and in the command palette. To add one, append it in
/// actions.cpp.
struct Action {
    std::string id;     // unique; item name for tests: "file.save"
    std::string menu;   // title of the menu that contains it: "File"
    std::string label;  // shown: "Save project"
    Shortcut shortcut;  // may have no key
    // Executes the action, usually by emitting a command. Called on the UI thread within a frame.
    std::function<void(PanelContext&, viewport::ViewportState&)> perform;
    std::function<bool(const commands::WorkbenchState&)> enabled = {};  // whether it can be used now; empty: always
    std::function<bool(const commands::WorkbenchState&)> checked = {};  // state of a toggle; empty: not a toggle
    bool separated = false;                                             // a separator above it in the menu
};

/// All actions in the order of the menus. The list never changes while the program runs.
const std::vector<Action>& all_actions();

/// Executes the actions whose shortcuts were pressed in this frame. Does nothing while the user types text or a dialog
/// is open.
void react_to_shortcuts(PanelContext& context, viewport::ViewportState& viewport);

}  // namespace myo::ui::panels
