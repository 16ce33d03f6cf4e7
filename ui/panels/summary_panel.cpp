#include "panels/summary_panel.hpp"

#include <imgui.h>

#include <utility>

#include "commands/settings_difference.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

using Row = std::pair<std::string, std::string>;  // name, value with unit

/// "fit, 81 samples at 100 Hz".
std::string trial_text(const commands::SceneTrial& trial) {
    const double interval = commands::sample_interval_s(trial);
    return trial.role + ", " + std::to_string(trial.time_s.size()) + " samples" +
           (interval > 0.0 ? " at " + plot::plain_label(1.0 / interval, 4) + " Hz" : "");
}

/// All rows: name, mesh, settings and trials.
std::vector<Row> summary_rows(const commands::WorkbenchState& state) {
    std::vector<Row> rows{{"Name", state.scene->name}};
    // A mesh of other settings would not be that of the rows below it.
    if (state.mesh_is_current())
        rows.push_back({"Mesh", with_separators(static_cast<double>(state.body->mesh.cell_count())) + " elements, " +
                                    with_separators(3.0 * static_cast<double>(state.body->mesh.node_count())) +
                                    " degrees of freedom"});
    for (const commands::SettingDifference& row :
         commands::settings_rows(state.settings, state.materials, state.integrators))
        rows.push_back({row.name, row.values.front()});
    for (const commands::SceneTrial& trial : state.scene->trials)
        rows.push_back({"Trial " + trial.name, trial_text(trial)});
    return rows;
}

/// Lines of name and value, separated by a tab: spreadsheets and documents paste it as a table.
std::string table_text(const std::vector<Row>& rows) {
    std::string text;
    for (const auto& [name, value] : rows) text += name + "\t" + value + "\n";
    return text;
}

}  // namespace

std::string SummaryPanel::title() const { return std::string(platform::icon::file) + "  Summary"; }

void SummaryPanel::draw(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    const std::vector<Row> rows = summary_rows(context.state);
    if (ImGui::Button("Copy")) ImGui::SetClipboardText(table_text(rows).c_str());
    context.items.mark("summary/copy");
    tooltip(theme, "Copies the table: name, tab, value");
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_PadOuterX | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                                      ImGuiTableFlags_BordersOuterH;
    if (!ImGui::BeginTable("summary", 2, flags)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 180.0f * theme.scale);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (const auto& [name, value] : rows) {
        ImGui::TableNextRow();
        text_cell(theme, name, theme.muted);
        text_cell(theme, value, theme.text);
        context.items.mark("summary/" + name);
    }
    ImGui::EndTable();
}

}  // namespace myo::ui::panels
