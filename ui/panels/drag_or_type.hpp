#pragma once

#include <span>
#include <string>

#include "platform/theme.hpp"

namespace myo::ui::panels {

/// A number that is dragged, and turns into a text field to type in. Dear ImGui's own drag field reads typed text with
/// scanf and limits it silently, so this one leaves the text to the caller.
struct DraggedNumber {
    double& shown;        // changed by dragging, within the limits
    double lowest;        // of the shown value
    double highest;       // of the shown value
    float speed;          // of the shown value per pixel
    std::string display;  // text while it is not typed in
};

/// What happened to the item in this frame.
enum class DragOrType {
    nothing,
    dragged,
    opened,     // a double click, Ctrl and a click, or Tab: text is typed from the next frame on
    typing,     // has the keyboard
    entered,    // Enter
    cancelled,  // Escape
    left        // the keyboard went elsewhere
};

/// Draws the number. The item is ImGui's last one afterwards, in all of its states.
///
/// @param id  of ImGui
DragOrType drag_number(const char* id, const DraggedNumber& number);

/// Draws the text field in place of the number, with the same id.
///
/// @param text  buffer with a terminating zero
/// @param was_active  it had the keyboard in the last frame
/// @param activate  it gets the keyboard now, with all text selected
/// @param refused  frame and text are red; at rest a click opens it
DragOrType type_number(const char* id, const platform::Theme& theme, std::span<char> text, bool was_active,
                       bool activate, bool refused);

}  // namespace myo::ui::panels
