#include "panels/jobs_panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/ticks.hpp"

namespace myo {
namespace {

/// Columns that all rows share; a waiting or running job leaves some empty.
constexpr int columns = 7;

const char* outcome_icon(JobOutcome outcome) {
    return outcome == JobOutcome::done ? icon::done : outcome == JobOutcome::stopped ? icon::stop : icon::failure;
}

bool small_button(PanelContext& context, const char* label, const std::string& item, const std::string& tip) {
    const bool pressed = ImGui::SmallButton(label);
    context.items.mark(item);
    tooltip(context.theme, tip);
    return pressed;
}

void running_row(PanelContext& context, const JobView& job) {
    const Theme& theme = context.theme;
    ImGui::TableNextRow();
    text_cell(theme, std::string(job.paused ? icon::pause : icon::play), theme.accent);
    text_cell(theme, job.name, theme.text);
    text_cell(theme, "", theme.muted);
    number_cell(theme, duration_label(job.elapsed_s));
    ImGui::TableNextColumn();
    const std::string inside = job.progress.total > 0.0 ? value_label(100.0 * job.fraction(), 2) + " %" : "working";
    ImGui::ProgressBar(static_cast<float>(job.fraction()), {-1.0f, ImGui::GetTextLineHeight()}, inside.c_str());
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    ImGui::BeginDisabled(job.cancelling);
    if (small_button(context, job.paused ? "Go on" : "Pause", "jobs/pause", "Stops at the next step until it goes on")) context.emit(command::Pause{!job.paused});
    ImGui::SameLine();
    if (small_button(context, "Cancel", "jobs/cancel", "Ends it; a search keeps its best values")) context.emit(command::Cancel{});
    ImGui::EndDisabled();
}

void waiting_row(PanelContext& context, const QueuedJob& job) {
    const Theme& theme = context.theme;
    ImGui::TableNextRow();
    text_cell(theme, icon::clock, theme.muted);
    text_cell(theme, job.name, theme.text);
    text_cell(theme, "", theme.muted);
    number_cell(theme, "");
    text_cell(theme, "waits", theme.muted);
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    if (small_button(context, "Take out", "jobs/unqueue/" + std::to_string(job.id), "It will not be run")) context.emit(command::Unqueue{job.id});
}

void record_row(PanelContext& context, const JobRecord& record) {
    const Theme& theme = context.theme;
    const std::string id = std::to_string(record.id);
    const ImVec4 color = record.outcome == JobOutcome::done ? theme.success : record.outcome == JobOutcome::stopped ? theme.warning : theme.failure;
    ImGui::TableNextRow();
    text_cell(theme, outcome_icon(record.outcome), color);
    text_cell(theme, record.name, theme.text);
    text_cell(theme, record.clock, theme.muted);
    number_cell(theme, record.seconds > 0.0 ? value_label(record.seconds, 3) + " s" : "");
    text_cell(theme, record.summary, theme.text);
    context.items.mark("jobs/record/" + id);
    ImGui::TableNextColumn();
    if (record.run) {
        bool compared = record.compared;
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0f, 0.0f));
        if (ImGui::Checkbox("##compare", &compared)) context.emit(command::CompareRecord{record.id, compared});
        ImGui::PopStyleVar();
        context.items.mark("jobs/compare/" + id);
        tooltip(theme, "Draw its markers in the plots beside those of the shown run");
    }
    ImGui::TableNextColumn();
    ImGui::BeginDisabled(!record.can_be_restored());
    if (small_button(context, "Restore", "jobs/restore/" + id, "Show it again, with its settings; undo brings the present ones back")) context.emit(command::RestoreRecord{record.id});
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (small_button(context, "Forget", "jobs/forget/" + id, "Take it off the list")) context.emit(command::ForgetRecord{record.id});
}

}  // namespace

std::string JobsPanel::title() const { return std::string(icon::tasks) + "  Jobs"; }

void JobsPanel::draw(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const Theme& theme = context.theme;
    if (!state.job && state.history.empty()) {
        muted_text(theme, "Runs, calibrations, searches and diagnoses are listed here, with what they brought, to be compared and taken up again. While one runs, "
                          "others can be asked for: they wait their turn.");
        return;
    }
    if (!ImGui::BeginTable("jobs", columns, ImGuiTableFlags_PadOuterX | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersOuterH)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    const std::vector<Heading> headings{{"", ""}, {"Job", ""}, {"Begun", ""}, {"Time", "Spent on it", true}, {"Result", ""}, {"Compare", "Its markers in the plots"}, {"", ""}};
    ImGui::TableSetupColumn("outcome", ImGuiTableColumnFlags_WidthFixed, 20.0f * theme.scale);
    ImGui::TableSetupColumn("job", ImGuiTableColumnFlags_WidthFixed, 110.0f * theme.scale);
    ImGui::TableSetupColumn("begun", ImGuiTableColumnFlags_WidthFixed, 64.0f * theme.scale);
    ImGui::TableSetupColumn("time", ImGuiTableColumnFlags_WidthFixed, 80.0f * theme.scale);
    ImGui::TableSetupColumn("result", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("compare", ImGuiTableColumnFlags_WidthFixed, 60.0f * theme.scale);
    ImGui::TableSetupColumn("actions", ImGuiTableColumnFlags_WidthFixed, 132.0f * theme.scale);
    heading_row(theme, headings);
    if (state.job) running_row(context, *state.job);
    for (const QueuedJob& job : state.queue) {
        ImGui::PushID(job.id);
        waiting_row(context, job);
        ImGui::PopID();
    }
    for (auto record = state.history.rbegin(); record != state.history.rend(); ++record) {
        ImGui::PushID(record->id);
        record_row(context, *record);
        ImGui::PopID();
    }
    ImGui::EndTable();
}

}  // namespace myo
