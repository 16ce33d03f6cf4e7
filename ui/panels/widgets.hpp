#pragma once

#include <array>
#include <string>
#include <vector>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Names of the coordinates for labels and item names.
inline constexpr std::array axis_names{"x", "y", "z"};

/// Shows a tooltip while the mouse is over the last item, also if it is disabled. Does nothing without text.
///
/// @param width  maximum width [pixels at scale 1]
void tooltip(const platform::Theme& theme, const std::string& text, float width = 380.0f);

/// A button that is one of several alternatives. Returns true if it was pressed.
bool tab(const platform::Theme& theme, const char* label, bool chosen);

/// A button as wide as the panel that switches something on and off. Returns true if it was pressed.
bool toggle_button(const platform::Theme& theme, const std::string& label, bool on);

/// Text at the right edge of the window.
void right_aligned(const std::string& text);
/// A heading within a panel.
void heading(const platform::Theme& theme, const std::string& text);

/// Formats a duration: "4.2 s", "42 s", "3 min 5 s", "1 h 2 min".
std::string duration_label(double seconds);

// Rows of the side panel: a label in the left column, the value in the right one, all aligned.
//
// `name` is the item name for tests, and, behind "##", also ImGui's id, so it must be unique in its window.

/// Draws the label and moves the cursor to the right column, with its width set for the next item.
///
/// @param tip  tooltip of the label
void row_label(const platform::Theme& theme, const std::string& label, const std::string& tip = {});

/// row_label() with a "?" at the end that opens the paragraph of the manual that defines the field.
///
/// @param name  item name of the field; a field without a paragraph has no "?"
void explained_label(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip);

/// Draws a label and a text that wraps. Afterwards both together are ImGui's last item.
///
/// @param color  of the text; null: the default
void text_row(const platform::Theme& theme, const std::string& label, const std::string& value,
              const ImVec4* color = nullptr);

/// Draws wrapped text in the secondary colour.
void muted_text(const platform::Theme& theme, const std::string& text);

/// Icon of a message.
const char* level_icon(commands::LogLevel level);

/// Draws a message with the icon of its level.
void notice(const platform::Theme& theme, commands::LogLevel level, const std::string& text);

/// Draws a message as notice() in a place of this many lines, whatever the text: nothing below it moves. A longer text
/// is shortened; its tooltip has the whole. An empty text leaves the place free. Afterwards the place is ImGui's last
/// item.
void notice_in_place(const platform::Theme& theme, commands::LogLevel level, const std::string& text, int lines);

/// A button in the accent colour, for the next thing to do. At most one should be visible at a time. Returns true if it
/// was pressed.
bool primary_button(const platform::Theme& theme, const std::string& label, const ImVec2& size);

/// Remembers which field is being dragged, so that undo treats all changes of one drag as one edit. One object per
/// group of fields, kept by the panel.
class OpenEdit {
public:
    /// Returns whether a change in this frame continues the drag of an earlier one. Call it right after the field's
    /// item.
    bool goes_on(const std::string& name, bool changed);
    /// The next change is an edit of its own.
    void close() { name_.clear(); }

private:
    std::string name_;  // field of the edit in progress; empty: none
};

/// Draws a slider below a number row, without a label. Returns true if the value changed.
///
/// @param shown  value in the shown unit; rounded to three significant digits
bool slider_row(PanelContext& context, const std::string& name, commands::Limits shown_limits, bool logarithmic,
                OpenEdit& edit, double& shown, bool& goes_on);

/// Draws a list. Returns true if another entry was selected.
///
/// @param id  id of the selected entry
bool choice_row(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip,
                const std::vector<commands::Choice>& choices, std::string& id);

/// Draws a list of the scene's markers in an item whose width is set; another selection emits ChooseMarker.
///
/// @param name  item name for tests
void marker_list(PanelContext& context, const std::string& name);

/// Opens and begins a modal dialog in the middle of the window, `width` [pixels at scale 1] wide. Returns false if it
/// is not drawn; otherwise the caller ends it with ImGui::EndPopup().
bool begin_dialog(const platform::Theme& theme, const char* title, float width);

/// Begins a popup that opens upwards from the last item, for buttons at the foot of the window. Escape closes it.
/// Returns false if it is not open; otherwise the caller ends it with ImGui::EndPopup().
bool begin_popup_above(const platform::Theme& theme, const char* name, float width);

/// Formats a count with separators: "12,345".
std::string with_separators(double count);

}  // namespace myo::ui::panels
