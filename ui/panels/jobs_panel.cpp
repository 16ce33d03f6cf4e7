#include "panels/jobs_panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "panels/check_marks.hpp"
#include "panels/job_comparison.hpp"
#include "panels/job_text.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Worst check of a job; green if it has none.
commands::CheckState state_of(const commands::JobRecord& record) {
    return record.checks ? commands::worst_state(record.checks->rows) : commands::CheckState::green;
}

/// A job that is done gets a tick only if its checks are green.
const char* record_icon(const commands::JobRecord& record) {
    if (record.outcome == commands::JobOutcome::failed) return platform::icon::failure;
    if (record.outcome == commands::JobOutcome::stopped) return platform::icon::stop;
    return state_of(record) == commands::CheckState::green ? platform::icon::done : check_icon(state_of(record));
}

/// Colour of the icon, by the severity that record_icon() shows.
ImVec4 record_color(const platform::Theme& theme, const commands::JobRecord& record) {
    if (record.outcome == commands::JobOutcome::failed) return theme.failure;
    return record.outcome == commands::JobOutcome::stopped ? theme.warning : check_color(theme, state_of(record));
}

/// "rms error 1.32 mm; checks: 1 amber".
std::string result_text(const commands::JobRecord& record) {
    if (state_of(record) == commands::CheckState::green) return record.summary;
    return record.summary + (record.summary.empty() ? "" : "; ") +
           "checks: " + commands::doubt_text(record.checks->rows);
}

// Icon buttons in narrow rows need a tooltip, so all buttons get one.
bool small_button(PanelContext& context, const char* label, const std::string& item, const std::string& tip) {
    const bool pressed = ImGui::SmallButton(label);
    context.items.mark(item);
    tooltip(context.theme, tip);
    return pressed;
}

/// Pause and Cancel.
void running_buttons(PanelContext& context, const commands::JobView& job, bool wide) {
    ImGui::BeginDisabled(job.cancelling);
    if (small_button(
            context,
            wide ? (job.paused ? "Resume" : "Pause") : (job.paused ? platform::icon::play : platform::icon::pause),
            "jobs/pause", "Pauses at the next step until resumed"))
        context.emit(commands::Pause{!job.paused});
    ImGui::SameLine();
    if (small_button(context, wide ? "Cancel" : platform::icon::stop, "jobs/cancel",
                     "Ends the job; a search keeps its best values"))
        context.emit(commands::Cancel{});
    ImGui::EndDisabled();
}

/// The running job: its progress, and buttons to pause and cancel it.
void running_row(PanelContext& context, const commands::JobView& job, bool wide) {
    const platform::Theme& theme = context.theme;
    ImGui::TableNextRow();
    text_cell(theme, std::string(job.paused ? platform::icon::pause : platform::icon::play), theme.accent);
    text_cell(theme, job.name, theme.text);
    if (wide) text_cell(theme, "", theme.muted), number_cell(theme, duration_label(job.elapsed_s));
    ImGui::TableNextColumn();
    const std::string counted = counted_text(job),
                      told = (counted.empty() ? "" : counted + " \xc2\xb7 ") + time_text(job);
    // The bar contains as much of the text as fits; its tooltip has all of it.
    const float room = ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x;
    const std::string inside = ImGui::CalcTextSize(told.c_str()).x <= room ? told : elided(time_text(job), room);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0f, 0.0f));  // aligned with the text of the other cells
    ImGui::ProgressBar(static_cast<float>(job.fraction()), {-1.0f, ImGui::GetTextLineHeight()}, inside.c_str());
    ImGui::PopStyleVar();
    context.items.mark("jobs/progress");
    tooltip(theme, told);
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    running_buttons(context, job, wide);
}

/// A waiting job can only be removed.
void waiting_row(PanelContext& context, const commands::QueuedJob& job, bool wide) {
    const platform::Theme& theme = context.theme;
    ImGui::TableNextRow();
    text_cell(theme, platform::icon::clock, theme.muted);
    text_cell(theme, job.name, theme.text);
    // Columns that exist only in the wide layout get empty cells here.
    if (wide) text_cell(theme, "", theme.muted), number_cell(theme, "");
    text_cell(theme, "waits", theme.muted);
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    if (small_button(context, wide ? "Remove" : platform::icon::remove, "jobs/unqueue/" + std::to_string(job.id),
                     "Removes the job from the queue"))
        context.emit(commands::Unqueue{job.id});
}

/// Draws the markers of the record with those of the shown run.
void compare_box(PanelContext& context, const commands::JobRecord& record) {
    const std::string id = std::to_string(record.id);
    bool compared = record.compared;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0f, 0.0f));
    if (ImGui::Checkbox("##compare", &compared)) context.emit(commands::CompareRecord{record.id, compared});
    ImGui::PopStyleVar();
    context.items.mark("jobs/compare/" + id);
    tooltip(context.theme,
            "Draw its markers with those of the shown run: as curves in the plots, as rings of the same colour "
            "in the view. The settings that differ are listed, too.");
}

/// An ended job. Compare exists only for jobs that kept their run.
void record_row(PanelContext& context, const commands::JobRecord& record, bool wide) {
    const platform::Theme& theme = context.theme;
    const std::string id = std::to_string(record.id);
    ImGui::TableNextRow();
    text_cell(theme, record_icon(record), record_color(theme, record));
    context.items.mark("jobs/icon/" + id);
    text_cell(theme, record.name, theme.text);
    // Cancelled and failed jobs have no measured time.
    const std::string time = record.seconds > 0.0 ? plot::value_label(record.seconds, 3) + " s" : "";
    // In the narrow layout start time and duration are in the tooltip of the name.
    if (wide)
        text_cell(theme, record.clock, theme.muted), number_cell(theme, time);
    else
        tooltip(theme, "Started " + record.clock + (time.empty() ? "" : ", took " + time));
    text_cell(theme, result_text(record), theme.text);
    context.items.mark("jobs/record/" + id);
    ImGui::TableNextColumn();
    if (record.run) compare_box(context, record);
    ImGui::TableNextColumn();
    // A failed job has nothing to show.
    ImGui::BeginDisabled(!record.can_be_restored());
    if (small_button(context, wide ? "Restore" : platform::icon::undo, "jobs/restore/" + id,
                     "Show it again, with its settings; undo restores the present ones"))
        context.emit(commands::RestoreRecord{record.id});
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (small_button(context, wide ? "Delete" : platform::icon::remove, "jobs/forget/" + id, "Delete it from the list"))
        context.emit(commands::ForgetRecord{record.id});
}

/// Column of the list.
struct JobColumn {
    Heading heading;
    float width;  // [pixels at scale 1]; 0: the remaining width
};

/// @param wide  with times, which are in tooltips otherwise, and with words on the buttons
std::vector<JobColumn> job_columns(bool wide) {
    std::vector<JobColumn> columns{
        {{"", ""}, 20.0f},
        {{"Job", ""}, 110.0f},
        {{"Result", ""}, 0.0f},
        {{wide ? "Compare" : "", "Its markers in the plots, and the settings that differ"}, wide ? 60.0f : 22.0f},
        {{"", ""}, wide ? 132.0f : 64.0f}};
    if (wide) columns.insert(columns.begin() + 2, {{{"Started", ""}, 64.0f}, {{"Time", "Wall time", true}, 80.0f}});
    return columns;
}

/// Columns and headings of the list.
void set_up_jobs(const platform::Theme& theme, const std::vector<JobColumn>& columns) {
    ImGui::TableSetupScrollFreeze(0, 1);
    std::vector<Heading> headings;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        headings.push_back(columns[k].heading);
        const ImGuiTableColumnFlags flags = columns[k].width > 0.0f ? ImGuiTableColumnFlags_WidthFixed
                                                                    : ImGuiTableColumnFlags_WidthStretch;
        ImGui::TableSetupColumn(std::to_string(k).c_str(), flags, columns[k].width * theme.scale);
    }
    heading_row(theme, headings);
}

}  // namespace

std::string JobsPanel::title() const { return std::string(platform::icon::tasks) + "  Jobs"; }

void JobsPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    if (!state.job && state.history.empty()) {
        muted_text(theme,
                   "Runs, calibrations, searches and diagnoses are listed here with their results, to be compared "
                   "and restored. While one runs, further jobs wait in a queue.");
        return;
    }
    // The comparison is drawn next to the list if there is room, otherwise below it.
    const ImVec2 room = ImGui::GetContentRegionAvail();
    // The comparison appears as soon as one job is selected: it is compared with the present.
    const bool compares = compares_jobs(state), beside = room.x > 900.0f * theme.scale;
    ImVec2 size{0.0f, 0.0f};
    if (compares && beside)
        size.x = room.x - 380.0f * theme.scale;
    else if (compares)
        size.y = 0.5f * room.y;
    draw_list(context, size);
    if (!compares) return;
    if (beside) ImGui::SameLine();
    draw_job_comparison(context);
}

/// The columns have fixed widths except for the result, which takes the rest. Column titles are left out where icons
/// say the same.
void JobsPanel::draw_list(PanelContext& context, const ImVec2& size) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const bool wide = (size.x > 0.0f ? size.x : ImGui::GetContentRegionAvail().x) >
                      620.0f * theme.scale;  // otherwise times are in tooltips and buttons are icons
    const std::vector<JobColumn> columns = job_columns(wide);
    if (!ImGui::BeginTable(
            "jobs", static_cast<int>(columns.size()),
            ImGuiTableFlags_PadOuterX | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersOuterH,
            size))
        return;
    set_up_jobs(theme, columns);
    // Running first, then waiting, then ended jobs with the newest on top.
    if (state.job) running_row(context, *state.job, wide);
    for (const commands::QueuedJob& job : state.queue) {
        ImGui::PushID(job.id);
        waiting_row(context, job, wide);
        ImGui::PopID();
    }
    for (auto record = state.history.rbegin(); record != state.history.rend(); ++record) {
        ImGui::PushID(record->id);
        record_row(context, *record, wide);
        ImGui::PopID();
    }
    ImGui::EndTable();
}

}  // namespace myo::ui::panels
