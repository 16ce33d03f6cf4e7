#include "panels/check_marks.hpp"

#include <imgui.h>

#include "panels/checks_panel.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

/// Icon and words that summarise the newest checks.
struct Mark {
    const char* sign;
    ImVec4 color;
    std::string words;
    std::string tip;  // tooltip
};

/// Three cases: no checks yet, checks of earlier settings, or checks of the present settings.
Mark mark_of(const commands::WorkbenchState& state, const platform::Theme& theme) {
    if (!state.checks) return {platform::icon::shield, theme.muted, "no checks yet", no_checks_text};
    const commands::CheckReport& report = *state.checks;
    const std::string counted = commands::count_text(report.rows) + "\nof " + report.job + ", started " + report.clock;
    // Outdated checks get a neutral colour: they say nothing about the present settings.
    if (!state.checks_are_current())
        return {platform::icon::stale, theme.muted, "checks: " + commands::doubt_text(report.rows) + ", outdated",
                counted + "\n" + stale_checks_text};
    const commands::CheckState worst = commands::worst_state(report.rows);
    return {check_icon(worst), check_color(theme, worst), "checks: " + commands::doubt_text(report.rows), counted};
}

/// Makes the last item a link to the panel of checks.
void go_to_checks(PanelContext& context) {
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemClicked()) context.window.panel = checks_panel_name;
}

}  // namespace

const char* check_icon(commands::CheckState state) {
    return state == commands::CheckState::green   ? platform::icon::check
           : state == commands::CheckState::amber ? platform::icon::warning
                                                  : platform::icon::failure;
}

const ImVec4& check_color(const platform::Theme& theme, commands::CheckState state) {
    return state == commands::CheckState::green   ? theme.success
           : state == commands::CheckState::amber ? theme.warning
                                                  : theme.failure;
}

void check_text(const platform::Theme& theme, commands::CheckState state, const std::string& words) {
    ImGui::TextColored(check_color(theme, state), "%s  %s", check_icon(state), words.c_str());
}

void checks_line(PanelContext& context, const commands::CheckRows& rows, const std::string& item) {
    if (rows.empty()) return;
    check_text(context.theme, commands::worst_state(rows), "Checks: " + commands::doubt_text(rows));
    context.items.mark(item);
    // The line names only what needs attention; the tooltip counts all states.
    tooltip(context.theme, commands::count_text(rows) + "\nClick to show the findings.");
    go_to_checks(context);
}

float checks_mark(PanelContext& context, float left, float right) {
    const platform::Theme& theme = context.theme;
    const Mark mark = mark_of(context.state, theme);
    // Without room for the words only the icon remains, with the words in its tooltip.
    const std::string all = std::string(mark.sign) + "  " + mark.words;
    const bool fits = left + ImGui::CalcTextSize(all.c_str()).x <= right;
    const std::string shown = fits ? all : mark.sign;
    // Flush right: the width changes with the words, the right edge does not.
    const float begin = right - ImGui::CalcTextSize(shown.c_str()).x;
    ImGui::SetCursorPosX(begin);
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(mark.color, "%s", shown.c_str());
    context.items.mark("bar/checks");
    tooltip(theme, fits ? mark.tip : mark.words + "\n" + mark.tip);
    go_to_checks(context);
    return begin;
}

}  // namespace myo::ui::panels
