#include "panels/checks_panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "panels/check_marks.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "panels/wrapped_text.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

/// First cell of a row; tests find the state of a check by it.
void draw_state(PanelContext& context, const commands::CheckRow& row, const std::string& number) {
    ImGui::TableNextColumn();
    check_text(context.theme, row.state, commands::check_word(row.state));
    context.items.mark("checks/state/" + number);
}

/// The question and, below it, the subject of the check.
void draw_question(const platform::Theme& theme, const commands::CheckRow& row) {
    wrapped_text(row.question);
    tooltip(theme, row.source.empty() ? row.id : row.id + "\nThreshold: " + row.source);
    if (!row.subject.empty()) muted_text(theme, row.subject);
}

/// The finding and, with an arrow, what the user can do.
void draw_sentence(const platform::Theme& theme, const commands::CheckRow& row) {
    wrapped_text(row.sentence);
    if (row.way_out.empty()) return;
    ImGui::TextColored(theme.accent, "%s", platform::icon::arrow);
    ImGui::SameLine(0.0f, 6.0f * theme.scale);
    wrapped_text(row.way_out);
}

// Two layouts: with room the value and its threshold have columns of their own, otherwise they follow the text.
void draw_wide_row(const platform::Theme& theme, const commands::CheckRow& row) {
    ImGui::TableNextColumn();
    draw_question(theme, row);
    ImGui::TableNextColumn();
    draw_sentence(theme, row);
    // Where the threshold comes from is of interest at both numbers.
    const std::string source = row.source.empty() ? "" : "Threshold: " + row.source;
    number_cell(theme, row.figure.empty() ? dash : row.figure);
    tooltip(theme, source);
    number_cell(theme, row.threshold.empty() ? dash : row.threshold, &theme.muted);
    tooltip(theme, source);
}

/// In a narrow panel value and threshold follow the text instead of having columns.
void draw_narrow_row(const platform::Theme& theme, const commands::CheckRow& row) {
    ImGui::TableNextColumn();
    draw_question(theme, row);
    draw_sentence(theme, row);
    if (row.figure.empty()) return;
    muted_text(theme, row.figure + (row.threshold.empty() ? "" : ", threshold " + row.threshold));
    tooltip(theme, row.source);
}

/// Columns and headings. `wide`: five columns instead of two.
void set_up_checks(const platform::Theme& theme, bool wide) {
    ImGui::TableSetupScrollFreeze(0, 1);
    // As wide as the longest word with its icon; the texts share what is left.
    const float state = ImGui::CalcTextSize((std::string(platform::icon::warning) + "  amber").c_str()).x;
    ImGui::TableSetupColumn("state", ImGuiTableColumnFlags_WidthFixed, state);
    ImGui::TableSetupColumn("check", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    if (wide) {
        ImGui::TableSetupColumn("found", ImGuiTableColumnFlags_WidthStretch, 2.2f);
        for (const char* name : {"figure", "threshold"})
            ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, 96.0f * theme.scale);
        heading_row(theme, {{"State", ""},
                            {"Check", ""},
                            {"Finding", "Finding and remedy"},
                            {"Value", "", true},
                            {"Threshold", "Hover over a threshold to see its source", true}});
    } else {
        heading_row(theme, {{"State", ""}, {"Check", "Finding and remedy"}});
    }
}

}  // namespace

std::string ChecksPanel::title() const { return std::string(platform::icon::shield) + "  Checks"; }

/// Before anything is open the panel explains what will appear.
void ChecksPanel::draw(PanelContext& context) {
    if (!context.state.checks) {
        muted_text(context.theme, no_checks_text);
        context.items.mark("checks/empty");
        return;
    }
    draw_head(context);
    draw_rows(context);
}

void ChecksPanel::draw_head(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    const commands::CheckReport& report = *context.state.checks;
    ImGui::BeginGroup();
    for (const commands::CheckState state :
         {commands::CheckState::green, commands::CheckState::amber, commands::CheckState::red}) {
        const auto is_of = [&](const commands::CheckRow& row) { return row.state == state; };
        const auto count = std::count_if(report.rows.begin(), report.rows.end(), is_of);
        // States without a check are left out, as in the summary of the menu bar.
        if (count == 0) continue;
        check_text(theme, state, std::to_string(count) + " " + commands::check_word(state));
        ImGui::SameLine(0.0f, 16.0f * theme.scale);
    }
    const std::string of = "of " + report.job + ", started " + report.clock;
    ImGui::TextColored(theme.muted, "%s", elided(of, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::EndGroup();
    context.items.mark("checks/head");
    // Outdated checks stay visible, as they still describe the shown run.
    if (context.state.checks_are_current()) return;
    ImGui::TextColored(theme.warning, "%s", platform::icon::stale);
    ImGui::SameLine(0.0f, 8.0f * theme.scale);
    wrapped_text(stale_checks_text);
    context.items.mark("checks/stale");
}

void ChecksPanel::draw_rows(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    const commands::CheckRows& rows = context.state.checks->rows;
    // Width [pixels at scale 1] below which five columns would break the texts into single words.
    const bool wide = ImGui::GetContentRegionAvail().x > 720.0f * theme.scale;
    // The table scrolls by itself, so that head and titles stay visible.
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_PadOuterX | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                                      ImGuiTableFlags_BordersOuterH;
    if (!ImGui::BeginTable("checks", wide ? 5 : 2, flags)) return;
    set_up_checks(theme, wide);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ImGui::TableNextRow();
        const std::string number = std::to_string(i);
        draw_state(context, rows[i], number);
        // Tests get the whole row; ImGui knows only its cells.
        const ImVec2 corner = ImGui::GetItemRectMin();
        if (wide)
            draw_wide_row(theme, rows[i]);
        else
            draw_narrow_row(theme, rows[i]);
        context.items.add("checks/row/" + number, {corner, ImGui::GetItemRectMax()});
    }
    ImGui::EndTable();
}

}  // namespace myo::ui::panels
