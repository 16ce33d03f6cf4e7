#include "panels/measure_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "commands/marker_errors.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "plot/ticks.hpp"

namespace myo {

void draw_trial_errors(PanelContext& context, const std::string& item) {
    const WorkbenchState& state = context.state;
    const std::shared_ptr<const RunResult> run = state.shown_run();
    if (!ImGui::BeginTable("trials", 3, ImGuiTableFlags_RowBg)) return;
    const std::vector<Heading> headings{{"Trial", ""}, {"Role", "Trials of role validate are predicted, never fitted."}, {"rms [mm]", "Error over all markers of the trial", true}};
    ImGui::TableSetupColumn("trial", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("role", ImGuiTableColumnFlags_WidthFixed);
    number_column(context.theme, headings[2]);
    heading_row(context.theme, headings);
    for (std::size_t t = 0; t < state.scene->trials.size(); ++t) {
        const SceneTrial& trial = state.scene->trials[t];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(t));
        if (ImGui::Selectable(elided(trial.name, ImGui::GetContentRegionAvail().x).c_str(), static_cast<int>(t) == state.trial, ImGuiSelectableFlags_SpanAllColumns))
            context.emit(command::ChooseTrial{static_cast<int>(t)});
        context.items.mark(item + trial.name);
        ImGui::PopID();
        text_cell(context.theme, trial.role, context.theme.muted);
        number_cell(context.theme, run && t < run->trials.size() ? millimetres(run->trials[t].rms_m) : "\xe2\x80\x93");
    }
    ImGui::EndTable();
}

void MeasurePanel::draw(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const Theme& theme = context.theme;
    if (!state.scene || state.scene->markers.empty()) return muted_text(theme, "Measured markers are compared with the simulation here. Open an experiment folder that has some.");
    if (state.run && !state.run_is_current()) notice(theme, LogLevel::information, "The settings changed since this run.");
    draw_trial_errors(context, "measure/trial/");
    const SceneTrial* const trial = state.scene_trial();
    if (!trial) return;
    heading(theme, "Markers of " + trial->name);
    if (tab(theme, "rms per axis", !bias_)) bias_ = false;
    context.items.mark("measure/rms");
    ImGui::SameLine();
    if (tab(theme, "Bias per axis", bias_)) bias_ = true;
    context.items.mark("measure/bias");
    const std::vector<MarkerError> errors = marker_errors(*state.scene, *trial, state.simulated_trial());
    const std::string what = bias_ ? "Mean of simulated less measured" : "Root mean square of simulated less measured";
    const std::vector<Heading> headings{{"[mm]", ""}, {"rms", "Over all three coordinates, from t = 0 on", true}, {"max", "Largest distance", true}, {"x", what, true}, {"y", what, true}, {"z", what, true},
                                        {"seen", "Share of the samples in which the marker was measured [%]", true}};
    if (!ImGui::BeginTable("markers", static_cast<int>(headings.size()), ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("marker", ImGuiTableColumnFlags_WidthStretch);
    for (std::size_t k = 1; k < headings.size(); ++k) ImGui::TableSetupColumn(headings[k].title.c_str(), ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize("\xe2\x88\x92" "0.00").x);
    heading_row(theme, headings);
    ImGui::PushFont(theme.small);
    for (std::size_t m = 0; m < errors.size(); ++m) {
        const MarkerError& error = errors[m];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(m));
        if (ImGui::Selectable(elided(error.name, ImGui::GetContentRegionAvail().x).c_str(), static_cast<int>(m) == state.marker, ImGuiSelectableFlags_SpanAllColumns))
            context.emit(command::ChooseMarker{static_cast<int>(m)});
        context.items.mark("measure/marker/" + error.name);
        tooltip(theme, error.name);
        ImGui::PopID();
        const Eigen::Vector3d& axes = bias_ ? error.bias_m : error.rms_axis_m;
        for (const double value : {error.rms_m, error.largest_m, axes.x(), axes.y(), axes.z()}) number_cell(theme, std::isfinite(value) ? value_label(1e3 * value, 2) : "\xe2\x80\x93");
        number_cell(theme, value_label(100.0 * error.seen, 3), error.seen < 0.8 ? &theme.warning : nullptr);
    }
    ImGui::PopFont();
    ImGui::EndTable();
}

}  // namespace myo
