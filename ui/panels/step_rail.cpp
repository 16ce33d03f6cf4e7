#include "panels/step_rail.hpp"

#include <imgui.h>

#include <array>

#include "panels/check_marks.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo {
namespace {

const char* icon_of(Step step) {
    static constexpr std::array<const char*, 9> icons{icon::cube, icon::grid, icon::flask, icon::brush, icon::play, icon::camera, icon::target, icon::stethoscope, icon::report};
    return icons[static_cast<std::size_t>(step)];
}

/// A ring, a dot, arrows, a tick, or the sign of its checks, so that the states differ without their colours, too.
void draw_state(ImDrawList& list, const ImVec2& center, const Theme& theme, const StepStatus& status) {
    const float s = theme.scale;
    const auto sign = [&](const char* text, const ImVec4& color) {
        const ImVec2 size = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, text);
        list.AddText(theme.small, theme.small->FontSize, {center.x - 0.5f * size.x, center.y - 0.5f * size.y}, packed(color), text);
    };
    const StepState state = status.state;
    if (state == StepState::missing) list.AddCircle(center, 4.0f * s, packed(theme.muted, 0.8f), 16, 1.3f * s);
    if (state == StepState::ready) list.AddCircleFilled(center, 4.0f * s, packed(theme.accent), 16);
    if (state == StepState::stale) sign(icon::stale, theme.warning);
    if (state == StepState::done) sign(check_icon(status.checks), check_color(theme, status.checks));
}

}  // namespace

void draw_step_rail(PanelContext& context, Step chosen, bool narrow) {
    const Theme& theme = context.theme;
    const float s = theme.scale, height = 36.0f * s, width = ImGui::GetWindowWidth();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const Step step : all_steps) {
        const StepStatus status = step_status(context.state, step);
        ImGui::SetCursorPosX(0.0f);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (ImGui::InvisibleButton(step_id(step), {width, height})) context.window.step = step;
        context.items.mark(std::string("step/") + step_id(step));
        const bool hovered = ImGui::IsItemHovered();
        const ImVec2 end{at.x + width, at.y + height};
        if (step == chosen || hovered) list.AddRectFilled(at, end, packed(step == chosen ? theme.raised : theme.hovered, step == chosen ? 1.0f : 0.5f));
        if (step == chosen) list.AddRectFilled(at, {at.x + 3.0f * s, end.y}, packed(theme.accent));
        const float line = theme.regular->FontSize, top = at.y + 0.5f * (height - line);
        const ImVec4& color = step == chosen ? theme.text : theme.muted;
        list.AddText(theme.regular, line, {at.x + 13.0f * s, top}, packed(color), icon_of(step));
        if (!narrow) list.AddText(step == chosen ? theme.strong : theme.regular, line, {at.x + 40.0f * s, top}, packed(color), step_title(step));
        const ImVec2 sign = narrow ? ImVec2(end.x - 8.0f * s, at.y + 9.0f * s)
                                   : ImVec2(end.x - 15.0f * s, at.y + 0.5f * height);
        draw_state(list, sign, theme, status);
        tooltip(theme, std::string(step_title(step)) + "\n" + status.next);
    }
}

void draw_step_head(PanelContext& context, Step step) {
    const StepStatus status = step_status(context.state, step);
    const Theme& theme = context.theme;
    const LogLevel levels[] = {LogLevel::information, LogLevel::information, LogLevel::warning,
                               log_level(status.checks)};
    notice(theme, levels[static_cast<int>(status.state)], status.next);
    context.items.mark("step/next");
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
}

}  // namespace myo
