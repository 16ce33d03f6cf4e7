#include "panels/check_marks.hpp"

#include <imgui.h>

#include "panels/checks_panel.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo {
namespace {

struct Mark {
    const char* sign;
    ImVec4 color;
    std::string words;
    std::string tip;
};

Mark mark_of(const WorkbenchState& state, const Theme& theme) {
    if (!state.checks) return {icon::shield, theme.muted, "no checks yet", no_checks_words};
    const CheckReport& report = *state.checks;
    const std::string counted = count_words(report.rows) + "\nof " + report.job + ", begun " + report.clock;
    if (!state.checks_are_current())
        return {icon::stale, theme.muted, "checks: " + doubt_words(report.rows) + ", outdated",
                counted + "\n" + stale_checks_words};
    const CheckState worst = worst_state(report.rows);
    return {check_icon(worst), check_color(theme, worst), "checks: " + doubt_words(report.rows), counted};
}

void go_to_checks(PanelContext& context) {
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemClicked()) context.window.panel = checks_panel_name;
}

}  // namespace

const char* check_icon(CheckState state) {
    return state == CheckState::green ? icon::check : state == CheckState::amber ? icon::warning : icon::failure;
}

const ImVec4& check_color(const Theme& theme, CheckState state) {
    return state == CheckState::green ? theme.success : state == CheckState::amber ? theme.warning : theme.failure;
}

void check_text(const Theme& theme, CheckState state, const std::string& words) {
    ImGui::TextColored(check_color(theme, state), "%s  %s", check_icon(state), words.c_str());
}

void checks_line(PanelContext& context, const CheckRows& rows, const std::string& item) {
    if (rows.empty()) return;
    check_text(context.theme, worst_state(rows), "Checks: " + doubt_words(rows));
    context.items.mark(item);
    tooltip(context.theme, count_words(rows) + "\nA click shows what was found.");
    go_to_checks(context);
}

float checks_mark(PanelContext& context, float left, float right) {
    const Theme& theme = context.theme;
    const Mark mark = mark_of(context.state, theme);
    const std::string all = std::string(mark.sign) + "  " + mark.words;
    const bool fits = left + ImGui::CalcTextSize(all.c_str()).x <= right;
    const std::string shown = fits ? all : mark.sign;
    const float begin = right - ImGui::CalcTextSize(shown.c_str()).x;
    ImGui::SetCursorPosX(begin);
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(mark.color, "%s", shown.c_str());
    context.items.mark("bar/checks");
    tooltip(theme, fits ? mark.tip : mark.words + "\n" + mark.tip);
    go_to_checks(context);
    return begin;
}

}  // namespace myo
