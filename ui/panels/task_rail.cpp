#include "panels/task_rail.hpp"

#include <imgui.h>

#include <array>

#include "panels/check_marks.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

/// Icons in the order of commands::Task.
const char* icon_of(commands::Task task) {
    static constexpr std::array<const char*, 9> icons{
        platform::icon::cube,   platform::icon::grid,        platform::icon::flask,
        platform::icon::brush,  platform::icon::play,        platform::icon::camera,
        platform::icon::target, platform::icon::stethoscope, platform::icon::report};
    return icons[static_cast<std::size_t>(task)];
}

/// Draws the state of a task: ring, dot, arrows, tick, or the icon of its checks. The shapes differ, so that states can
/// be distinguished without colours.
void draw_state(ImDrawList& list, const ImVec2& center, const platform::Theme& theme,
                const commands::TaskStatus& status) {
    const float s = theme.scale;
    const auto sign = [&](const char* text, const ImVec4& color) {
        const ImVec2 size = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, text);
        list.AddText(theme.small, theme.small->FontSize, {center.x - 0.5f * size.x, center.y - 0.5f * size.y},
                     platform::packed(color), text);
    };
    const commands::TaskState state = status.state;
    if (state == commands::TaskState::missing)
        list.AddCircle(center, 4.0f * s, platform::packed(theme.muted, 0.8f), 16, 1.3f * s);
    if (state == commands::TaskState::ready) list.AddCircleFilled(center, 4.0f * s, platform::packed(theme.accent), 16);
    if (state == commands::TaskState::stale) sign(platform::icon::stale, theme.warning);
    if (state == commands::TaskState::done) sign(check_icon(status.checks), check_color(theme, status.checks));
}

/// Background of the selected task, or of the one under the mouse.
void draw_background(ImDrawList& list, const platform::Theme& theme, const ImVec2& at, const ImVec2& end, bool chosen) {
    list.AddRectFilled(at, end, platform::packed(chosen ? theme.raised : theme.hovered, chosen ? 1.0f : 0.5f));
    // A bar at the left edge marks the selected task, in addition to its background.
    if (chosen) list.AddRectFilled(at, {at.x + 3.0f * theme.scale, end.y}, platform::packed(theme.accent));
}

}  // namespace

/// Each task is a full-width button with icon, title and state. The tooltip says what to do next.
void draw_task_rail(PanelContext& context, commands::Task chosen, bool narrow) {
    const platform::Theme& theme = context.theme;
    const float s = theme.scale, height = 36.0f * s, width = ImGui::GetWindowWidth();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const commands::Task task : commands::all_tasks) {
        const commands::TaskStatus status = commands::task_status(context.state, task);
        ImGui::SetCursorPosX(0.0f);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        // Buttons over the full width, without ImGui's frame; everything is drawn over them.
        if (ImGui::InvisibleButton(commands::task_id(task), {width, height})) context.window.task = task;
        context.items.mark(std::string("task/") + commands::task_id(task));
        const bool hovered = ImGui::IsItemHovered();
        const ImVec2 end{at.x + width, at.y + height};
        if (task == chosen || hovered) draw_background(list, theme, at, end, task == chosen);
        const float line = theme.regular->FontSize, top = at.y + 0.5f * (height - line);
        const ImVec4& color = task == chosen ? theme.text : theme.muted;
        list.AddText(theme.regular, line, {at.x + 13.0f * s, top}, platform::packed(color), icon_of(task));
        if (!narrow)
            list.AddText(task == chosen ? theme.strong : theme.regular, line, {at.x + 40.0f * s, top},
                         platform::packed(color), commands::task_title(task));
        // In the narrow rail the state moves to the corner of the icon.
        const ImVec2 sign = narrow ? ImVec2(end.x - 8.0f * s, at.y + 9.0f * s)
                                   : ImVec2(end.x - 15.0f * s, at.y + 0.5f * height);
        draw_state(list, sign, theme, status);
        // The chosen task says it at the top of its panel, which the tooltip would cover.
        if (task != chosen) tooltip(theme, std::string(commands::task_title(task)) + "\n" + status.next);
    }
}

/// An outdated task is a warning; a task that is done has the severity of its checks. A refused edit takes the place,
/// as it is what the user has just done.
void draw_task_head(PanelContext& context, commands::Task task) {
    const commands::TaskStatus status = commands::task_status(context.state, task);
    // Severity for each TaskState, in its order.
    const commands::LogLevel levels[] = {commands::LogLevel::information, commands::LogLevel::information,
                                         commands::LogLevel::warning, commands::log_level(status.checks)};
    constexpr int lines = 3;
    const std::string& refused = context.state.refused;
    if (refused.empty())
        notice_in_place(context.theme, levels[static_cast<int>(status.state)], status.next, lines);
    else
        notice_in_place(context.theme, commands::LogLevel::warning, refused, lines);
    context.items.mark(refused.empty() ? "task/next" : "task/refused");
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
}

}  // namespace myo::ui::panels
