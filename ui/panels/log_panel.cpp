#include "panels/log_panel.hpp"

#include <imgui.h>

#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {

std::string LogPanel::title() const { return std::string(platform::icon::list) + "  Messages"; }

void LogPanel::forget_heights(float width, float scale) {
    // Another width or scale wraps the lines differently.
    heights_.clear();
    width_ = width;
    scale_ = scale;
}

// Numbers since the start identify lines, as old ones are removed at the front.
void LogPanel::draw(PanelContext& context) {
    const std::vector<commands::LogLine>& lines = context.state.log;
    if (lines.empty()) muted_text(context.theme, "No messages yet.");
    const std::size_t logged = context.state.logged;
    const float width = ImGui::GetContentRegionAvail().x;
    if (width != width_ || context.theme.scale != scale_) forget_heights(width, context.theme.scale);
    // Wrapped lines differ in height. Each is measured once and afterwards drawn only if it is visible; thousands of
    // lines would slow down every frame.
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::size_t number = logged - lines.size() + i;
        const auto known = heights_.find(number);
        if (known != heights_.end() && !ImGui::IsRectVisible({width, known->second})) {
            // Keeps the place of the line, so that scrolling is not affected.
            ImGui::Dummy({1.0f, known->second});
            continue;
        }
        ImGui::BeginGroup();
        notice(context.theme, lines[i].level, lines[i].text);
        ImGui::EndGroup();
        context.items.mark("messages/line/" + std::to_string(i));
        heights_[number] = ImGui::GetItemRectSize().y;
    }
    // Heights of messages that have left the log.
    heights_.erase(heights_.begin(), heights_.lower_bound(logged - lines.size()));
    // Scroll to the end only when a message arrives, so that the user can read earlier ones.
    if (logged != seen_) ImGui::SetScrollHereY(1.0f);
    seen_ = logged;
}

}  // namespace myo::ui::panels
