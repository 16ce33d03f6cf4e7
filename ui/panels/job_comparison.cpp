#include "panels/job_comparison.hpp"

#include <imgui.h>

#include <cmath>

#include "commands/settings_difference.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// A column of the table: an ended job, or the present settings.
struct Compared {
    std::string title, tip;
    const commands::Settings* settings = nullptr;  // owned by the state
    const commands::RunResult* run = nullptr;      // owned by the state; null: no error is known
};

/// The compared jobs in order, then the present.
std::vector<Compared> columns_of(const commands::WorkbenchState& state) {
    std::vector<Compared> columns;
    for (const commands::JobRecord& record : state.history)
        if (record.compared)
            columns.push_back(
                {record.clock, record.name + ", started " + record.clock, &record.settings, record.run.get()});
    // The present is always the last column.
    columns.push_back({"Now", "The present settings, and the error of the run with them", &state.settings,
                       // An outdated run does not belong to the present settings.
                       state.run_is_current() ? state.run.get() : nullptr});
    return columns;
}

/// Error of a run, or a dash.
std::string error_of(const commands::RunResult* run) {
    return run && std::isfinite(run->rms_m) ? plot::millimetres(run->rms_m) : "\xe2\x80\x93";
}

/// Columns and headings of the comparison.
void set_up_comparison(const platform::Theme& theme, const std::vector<Compared>& columns) {
    ImGui::TableSetupScrollFreeze(1, 1);
    std::vector<Heading> headings{{"Differs in", ""}};
    ImGui::TableSetupColumn("setting", ImGuiTableColumnFlags_WidthFixed, 128.0f * theme.scale);
    for (const Compared& column : columns) {
        headings.push_back({column.title, column.tip, true});
        ImGui::TableSetupColumn(column.title.c_str(), ImGuiTableColumnFlags_WidthFixed, 92.0f * theme.scale);
    }
    heading_row(theme, headings);
}

/// Row of a setting in which the columns differ: its name and the value of each column.
void difference_row(PanelContext& context, const commands::SettingDifference& row) {
    const platform::Theme& theme = context.theme;
    ImGui::TableNextRow();
    text_cell(theme, row.name, theme.muted);
    context.items.mark("jobs/differs/" + row.name);
    for (const std::string& value : row.values) {
        // Long values, such as signals, are shortened; the tooltip has all of them.
        const std::string shown = elided(value, 92.0f * theme.scale);
        number_cell(theme, shown);
        if (shown != value) tooltip(theme, value);
    }
}

}  // namespace

bool compares_jobs(const commands::WorkbenchState& state) {
    for (const commands::JobRecord& record : state.history)
        if (record.compared) return true;
    return false;
}

/// The first column and the row of titles stay in place while the table scrolls in both directions.
void draw_job_comparison(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const std::vector<Compared> columns = columns_of(state);
    // One column of values per job, in the order of the headings.
    std::vector<const commands::Settings*> settings;
    for (const Compared& column : columns) settings.push_back(column.settings);
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_PadOuterX | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                                      ImGuiTableFlags_ScrollX | ImGuiTableFlags_BordersOuterH;
    if (!ImGui::BeginTable("differences", 1 + static_cast<int>(columns.size()), flags)) return;
    set_up_comparison(theme, columns);
    ImGui::TableNextRow();
    text_cell(theme, "rms error", theme.muted);
    for (const Compared& column : columns) number_cell(theme, error_of(column.run));
    // The table lists only settings that differ, so that a comparison stays short.
    const std::vector<commands::SettingDifference> differences = commands::settings_differences(
        settings, state.materials, state.integrators);
    for (const commands::SettingDifference& row : differences) {
        difference_row(context, row);
    }
    if (differences.empty()) {
        ImGui::TableNextRow();
        text_cell(theme, "no setting", theme.muted);
    }
    ImGui::EndTable();
    context.items.mark("jobs/differences");
}

}  // namespace myo::ui::panels
