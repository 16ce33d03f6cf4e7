#include "panels/measure_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "commands/marker_csv.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {

// Shared with the panel of the run, hence the prefix of the item names.
void draw_trial_errors(PanelContext& context, const std::string& item, const commands::RunResult* run) {
    const commands::WorkbenchState& state = context.state;
    if (!begin_side_table("trials", 3)) return;
    const std::vector<Heading> headings{{"Trial", ""},
                                        {"Role", "Trials of role validate are predicted only."},
                                        {"rms [mm]", "Error over all markers of the trial", true}};
    ImGui::TableSetupColumn("trial", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("role", ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize("validate").x);
    number_column(context.theme, headings[2]);
    heading_row(context.theme, headings);
    // All trials are listed, also those that the run lacks, so that each can be chosen.
    for (std::size_t t = 0; t < state.scene->trials.size(); ++t) {
        const commands::SceneTrial& trial = state.scene->trials[t];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(t));
        if (ImGui::Selectable(elided(trial.name, ImGui::GetContentRegionAvail().x).c_str(),
                              static_cast<int>(t) == state.trial, ImGuiSelectableFlags_SpanAllColumns))
            context.emit(commands::ChooseTrial{static_cast<int>(t)});
        context.items.mark(item + trial.name);
        ImGui::PopID();
        text_cell(context.theme, trial.role, context.theme.muted);
        // A run may lack the trial, and a trial without markers has no error.
        number_cell(context.theme, run && t < run->trials.size() && std::isfinite(run->trials[t].rms_m)
                                       ? plot::value_label(1e3 * run->trials[t].rms_m, 3)
                                       : "\xe2\x80\x93");
    }
    ImGui::EndTable();
}

namespace {

/// The button below the tables, also shown for a body without markers.
void draw_import_button(PanelContext& context) {
    ImGui::Spacing();
    if (ImGui::Button("Import a recording\xe2\x80\xa6"))
        context.window.file = recording_dialog(context.state.scene->path);
    context.items.mark("measure/import");
    tooltip(context.theme,
            "Makes a trial from a motion-capture file: C3D, TRC, Motive or Nexus CSV, Qualisys TSV, CSV, or a "
            "table of x, y, z of each marker");
}

/// Saves the table of errors as CSV.
void draw_save_button(PanelContext& context, const std::string& trial,
                      const std::vector<commands::MarkerError>& errors) {
    if (ImGui::Button("Save the table\xe2\x80\xa6"))
        context.window.file = table_dialog("Save the markers' errors", trial + "_errors",
                                           commands::marker_errors_csv(errors));
    context.items.mark("measure/csv");
    tooltip(context.theme,
            "Saves rms, largest distance, rms, max and bias per axis [m] and the share of samples seen, of every "
            "marker of this trial, as CSV");
}

}  // namespace

/// Errors of the trials, then errors of the markers of the shown trial: in all, or one quantity per axis.
void MeasurePanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    if (!state.scene || state.scene->markers.empty()) {
        muted_text(theme,
                   "Measured markers are compared with the simulation here. Open an experiment folder that has some, "
                   "or import a recording of this body.");
        if (state.scene) draw_import_button(context);
        return;
    }
    draw_trial_errors(context, "measure/trial/", state.shown_run().get());
    const commands::SceneTrial* const trial = state.scene_trial();
    draw_import_button(context);
    // An experiment without trials has markers, but no errors.
    if (!trial) return;
    heading(theme, "Markers of " + trial->name);
    draw_tabs(context);
    // Computed in each frame: one pass over the samples of the shown trial.
    const std::vector<commands::MarkerError> errors = commands::marker_errors(*state.scene, *trial,
                                                                              state.simulated_trial());
    draw_table(context, errors);
    ImGui::Spacing();
    draw_save_button(context, trial->name, errors);
}

void MeasurePanel::draw_tabs(PanelContext& context) {
    struct Tab {
        Shown shown;
        const char* label;
        const char* item;
        const char* tip;
    };
    for (const Tab& t : {Tab{Shown::whole, "Total", "measure/whole", "All three coordinates together"},
                         Tab{Shown::rms, "rms", "measure/rms", "Root mean square in x, y and z"},
                         Tab{Shown::largest, "max", "measure/largest", "Largest error in x, y and z"},
                         Tab{Shown::bias, "Bias", "measure/bias", "Mean error in x, y and z"}}) {
        if (t.shown != Shown::whole) ImGui::SameLine();
        if (tab(context.theme, t.label, shown_ == t.shown)) shown_ = t.shown;
        context.items.mark(t.item);
        tooltip(context.theme, t.tip);
    }
}

std::vector<Heading> MeasurePanel::headings() const {
    // The three tables per axis share their columns; only the tooltip differs.
    const std::string what = shown_ == Shown::bias      ? "Mean of simulated minus measured [mm]"
                             : shown_ == Shown::largest ? "Largest magnitude of simulated minus measured [mm]"
                                                        : "Root mean square of simulated minus measured [mm]";
    // The first table has one number per error, the others one per axis.
    const std::vector<Heading> whole{{"Marker", ""},
                                     {"rms [mm]", "Over all three coordinates, from t = 0 on", true},
                                     {"max [mm]", "Largest distance", true},
                                     {"seen [%]", "Share of the samples in which the marker was measured", true}};
    const std::vector<Heading> axes{
        {"Marker", ""}, {"x [mm]", what, true}, {"y [mm]", what, true}, {"z [mm]", what, true}};
    return shown_ == Shown::whole ? whole : axes;
}

void MeasurePanel::draw_error_row(PanelContext& context, const commands::MarkerError& error, std::size_t m) {
    const platform::Theme& theme = context.theme;
    // A length in millimetres, or a dash.
    const auto length = [&](double metres) {
        number_cell(theme, std::isfinite(metres) ? plot::value_label(1e3 * metres, 2) : "\xe2\x80\x93");
    };
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(m));
    if (ImGui::Selectable(elided(error.name, ImGui::GetContentRegionAvail().x).c_str(),
                          static_cast<int>(m) == context.state.marker, ImGuiSelectableFlags_SpanAllColumns))
        context.emit(commands::ChooseMarker{static_cast<int>(m)});
    context.items.mark("measure/marker/" + error.name);
    tooltip(theme, error.name);
    ImGui::PopID();
    if (shown_ == Shown::whole) {
        length(error.rms_m);
        length(error.largest_m);
        // below 80 % the error rests on few samples
        number_cell(theme, plot::value_label(100.0 * error.seen, 3), error.seen < 0.8 ? &theme.warning : nullptr);
    } else {
        for (const double value : shown_ == Shown::bias      ? error.bias_m
                                  : shown_ == Shown::largest ? error.largest_axis_m
                                                             : error.rms_axis_m)
            length(value);
    }
}

void MeasurePanel::draw_table(PanelContext& context, const std::vector<commands::MarkerError>& errors) {
    const std::vector<Heading> headings = this->headings();
    if (!begin_side_table("markers", static_cast<int>(headings.size()))) return;
    ImGui::TableSetupColumn("marker", ImGuiTableColumnFlags_WidthStretch);
    for (std::size_t k = 1; k < headings.size(); ++k) number_column(context.theme, headings[k]);
    heading_row(context.theme, headings);
    for (std::size_t m = 0; m < errors.size(); ++m) draw_error_row(context, errors[m], m);
    ImGui::EndTable();
}

}  // namespace myo::ui::panels
