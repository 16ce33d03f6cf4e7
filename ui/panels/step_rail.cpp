#include "panels/step_rail.hpp"

#include <imgui.h>

#include <array>

#include "panels/check_marks.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

/// Icons in the order of commands::Step.
const char* icon_of(commands::Step step) {
    static constexpr std::array<const char*, 9> icons{
        platform::icon::cube,   platform::icon::grid,        platform::icon::flask,
        platform::icon::brush,  platform::icon::play,        platform::icon::camera,
        platform::icon::target, platform::icon::stethoscope, platform::icon::report};
    return icons[static_cast<std::size_t>(step)];
}

/// Draws the state of a task: ring, dot, arrows, tick, or the icon of its checks. The shapes differ, so that states can
/// be distinguished without colours.
void draw_state(ImDrawList& list, const ImVec2& center, const platform::Theme& theme,
                const commands::StepStatus& status) {
    const float s = theme.scale;
    const auto sign = [&](const char* text, const ImVec4& color) {
        const ImVec2 size = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, text);
        list.AddText(theme.small, theme.small->FontSize, {center.x - 0.5f * size.x, center.y - 0.5f * size.y},
                     platform::packed(color), text);
    };
    const commands::StepState state = status.state;
    if (state == commands::StepState::missing)
        list.AddCircle(center, 4.0f * s, platform::packed(theme.muted, 0.8f), 16, 1.3f * s);
    if (state == commands::StepState::ready) list.AddCircleFilled(center, 4.0f * s, platform::packed(theme.accent), 16);
    if (state == commands::StepState::stale) sign(platform::icon::stale, theme.warning);
    if (state == commands::StepState::done) sign(check_icon(status.checks), check_color(theme, status.checks));
}

}  // namespace

/// Each task is a full-width button with icon, title and state. The tooltip says what to do next.
void draw_step_rail(PanelContext& context, commands::Step chosen, bool narrow) {
    const platform::Theme& theme = context.theme;
    const float s = theme.scale, height = 36.0f * s, width = ImGui::GetWindowWidth();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const commands::Step step : commands::all_steps) {
        const commands::StepStatus status = commands::step_status(context.state, step);
        ImGui::SetCursorPosX(0.0f);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        // Buttons over the full width, without ImGui's frame; everything is drawn over them.
        if (ImGui::InvisibleButton(commands::step_id(step), {width, height})) context.window.step = step;
        context.items.mark(std::string("step/") + commands::step_id(step));
        const bool hovered = ImGui::IsItemHovered();
        const ImVec2 end{at.x + width, at.y + height};
        if (step == chosen || hovered)
            list.AddRectFilled(
                at, end, platform::packed(step == chosen ? theme.raised : theme.hovered, step == chosen ? 1.0f : 0.5f));
        // A bar at the left edge marks the selected task, in addition to its background.
        if (step == chosen) list.AddRectFilled(at, {at.x + 3.0f * s, end.y}, platform::packed(theme.accent));
        const float line = theme.regular->FontSize, top = at.y + 0.5f * (height - line);
        const ImVec4& color = step == chosen ? theme.text : theme.muted;
        list.AddText(theme.regular, line, {at.x + 13.0f * s, top}, platform::packed(color), icon_of(step));
        if (!narrow)
            list.AddText(step == chosen ? theme.strong : theme.regular, line, {at.x + 40.0f * s, top},
                         platform::packed(color), commands::step_title(step));
        // In the narrow rail the state moves to the corner of the icon.
        const ImVec2 sign = narrow ? ImVec2(end.x - 8.0f * s, at.y + 9.0f * s)
                                   : ImVec2(end.x - 15.0f * s, at.y + 0.5f * height);
        draw_state(list, sign, theme, status);
        tooltip(theme, std::string(commands::step_title(step)) + "\n" + status.next);
    }
}

/// An outdated task is a warning; a task that is done has the severity of its checks.
void draw_step_head(PanelContext& context, commands::Step step) {
    const commands::StepStatus status = commands::step_status(context.state, step);
    const platform::Theme& theme = context.theme;
    // Severity for each StepState, in its order.
    const commands::LogLevel levels[] = {commands::LogLevel::information, commands::LogLevel::information,
                                         commands::LogLevel::warning, commands::log_level(status.checks)};
    notice(theme, levels[static_cast<int>(status.state)], status.next);
    context.items.mark("step/next");
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
}

}  // namespace myo::ui::panels
