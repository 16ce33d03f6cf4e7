#include "panels/log_panel.hpp"

#include <imgui.h>

#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo {

std::string LogPanel::title() const { return std::string(icon::list) + "  Messages"; }

void LogPanel::draw(PanelContext& context) {
    if (context.state.log.empty()) muted_text(context.theme, "No messages yet.");
    for (const LogLine& line : context.state.log) notice(context.theme, line.level, line.text);
    if (context.state.log.size() != seen_) ImGui::SetScrollHereY(1.0f);
    seen_ = context.state.log.size();
}

}  // namespace myo
