#pragma once

#include "panels/panel.hpp"

// State of checks as an icon, a colour and a word. Only green is shown with a tick.

namespace myo::ui::panels {

/// Icon and colour of a state.
const char* check_icon(commands::CheckState state);
/// Colour of a state: a reference into the theme, which must outlive it.
const ImVec4& check_color(const platform::Theme& theme, commands::CheckState state);

/// Draws icon and words in the colour of the state.
void check_text(const platform::Theme& theme, commands::CheckState state, const std::string& words);

/// Draws a line such as "Checks: 1 amber". A click shows the panel of checks. Draws nothing without rows.
///
/// @param item  item name for tests
void checks_line(PanelContext& context, const commands::CheckRows& rows, const std::string& item);

/// Draws the summary of the newest checks in the menu bar, flush right at `right` [pixels in the window]. Only the icon
/// is drawn if the words would begin before `left`. Returns the x at which it begins.
float checks_mark(PanelContext& context, float left, float right);

}  // namespace myo::ui::panels
