#pragma once

#include "panels/panel.hpp"

// The state of checks, by a sign, a colour and a word. Only green has the sign of a tick.

namespace myo::ui::panels {

const char* check_icon(commands::CheckState state);
const ImVec4& check_color(const platform::Theme& theme, commands::CheckState state);

/// Sign and words in the colour of the state.
void check_text(const platform::Theme& theme, commands::CheckState state, const std::string& words);

/// "Checks: 1 amber" on a line; a click brings the panel of checks to the front. Nothing without rows.
void checks_line(PanelContext& context, const commands::CheckRows& rows, const std::string& item);

/// The same in short, for the bar at the top: of the newest checks, or that there are none yet. It ends at `right`;
/// only the sign where the words would begin before `left`. Returns where it begins.
float checks_mark(PanelContext& context, float left, float right);

}  // namespace myo::ui::panels
