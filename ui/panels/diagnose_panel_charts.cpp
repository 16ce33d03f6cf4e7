#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/letter_case.hpp"
#include "panels/diagnose_panel.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

// The charts of the panel: residual, force, and numerical errors.

namespace myo::ui::panels {

namespace {

/// The measured residual of the shown marker and the change that the row predicts.
plot::Plot residual_plot(const PanelContext& context, const commands::DiagnosisRow& row, int axis) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const auto trial = static_cast<std::size_t>(state.trial), marker = static_cast<std::size_t>(state.marker);
    const commands::DiagnosisView& d = *state.diagnosis;
    plot::Plot plot;
    plot.id = "diagnose/plot";
    // The legend needs the room more than the title does.
    const std::string axis_name = axis_names[static_cast<std::size_t>(axis)];
    plot.panel.y = {.label = ImGui::GetContentRegionAvail().x > 440.0f * theme.scale
                                 ? axis_name + " \xe2\x88\x92 that of the declared model"
                                 : "\xce\x94" + axis_name,
                    .unit = "mm",
                    .include_zero = true};
    plot.cursor = state.time_s;
    plot.panel.vertical = {{0.0, ""}};
    plot.legend = true;
    // Residuals have the sample times of the trial.
    const Eigen::VectorXd& time = state.scene_trial()->time_s;
    plot.panel.series.push_back(plot::plot_series(
        "measured", time, 1e3 * d.trials[trial].residual_m[marker].row(axis).transpose(), theme.measured, true));
    // A row that was not predicted for this trial shows the measurement only.
    const bool predicted = trial < row.predicted_m.size() && marker < row.predicted_m[trial].size();
    if (predicted)
        plot.panel.series.push_back(plot::plot_series("with " + lower_first(row.name), time,
                                                      1e3 * row.predicted_m[trial][marker].row(axis).transpose(),
                                                      theme.simulated));
    return plot;
}

/// Columns and headings of the table of errors.
void set_up_errors(const platform::Theme& theme, const commands::DiagnosisRow& row) {
    const std::string of_noise = " [\xc3\x97 noise]";
    const std::string before = "rms error over the markers of the declared model, its parameters fitted",
                      after = "with " + lower_first(row.name) + " fitted with them";
    const std::vector<Heading> headings{{"Trial", ""},
                                        {"Role", "Predicted trials were not used in any fit or choice."},
                                        {"Before [mm]", before, true},
                                        {"After [mm]", after, true},
                                        {"Before" + of_noise, before, true},
                                        {"After" + of_noise, after, true}};
    ImGui::TableSetupColumn("trial", ImGuiTableColumnFlags_WidthStretch);
    // In a narrow window the role is in the tooltip, and the columns in noise levels are left out.
    const int where_wide = ImGui::GetWindowWidth() < 480.0f * theme.scale ? ImGuiTableColumnFlags_Disabled : 0;
    ImGui::TableSetupColumn("role", ImGuiTableColumnFlags_WidthFixed | where_wide,
                            ImGui::CalcTextSize("predicted").x + 2.0f);
    for (std::size_t k = 2; k < headings.size(); ++k) number_column(theme, headings[k], k == 4 ? where_wide : 0);
    heading_row(theme, headings);
}

/// Errors of one trial.
void error_row(PanelContext& context, const commands::DiagnosisRow& row, std::size_t t) {
    const platform::Theme& theme = context.theme;
    const commands::DiagnosisView& d = *context.state.diagnosis;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const commands::DiagnosisTrial& trial = d.trials[t];
    ImGui::PushID(static_cast<int>(t));
    if (ImGui::Selectable(elided(trial.name, ImGui::GetContentRegionAvail().x).c_str(),
                          static_cast<int>(t) == context.state.trial, ImGuiSelectableFlags_SpanAllColumns))
        context.emit(commands::ChooseTrial{static_cast<int>(t)});
    context.items.mark("diagnose/error/" + trial.name);
    tooltip(theme, trial.name + (trial.fitted ? ", fitted" : ", predicted"));
    ImGui::PopID();
    text_cell(theme, trial.fitted ? "fit" : "predicted", theme.text);
    // A row that was not fitted has no errors: dashes.
    const double after_m = t < row.after_m.size() ? row.after_m[t] : std::nan("");
    // Each error twice: in millimetres and in noise levels.
    for (const double factor : {1e3, 1.0 / d.noise_m}) {
        number_cell(theme, plot::value_label(factor * trial.before_m, 3));
        number_cell(theme, plot::value_label(factor * after_m, 3), after_m < trial.before_m ? &theme.success : nullptr);
    }
}

}  // namespace

/// Both curves are differences from the declared model: the measured one is what it lacks, the predicted one what the
/// row adds. They coincide if the row explains the residual.
void DiagnosePanel::draw_residual(PanelContext& context, const commands::DiagnosisRow& row) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const auto trial = static_cast<std::size_t>(state.trial), marker = static_cast<std::size_t>(state.marker);
    const commands::DiagnosisView& d = *state.diagnosis;
    // Residuals appear trial by trial while the diagnosis runs.
    if (trial >= d.trials.size() || marker >= d.trials[trial].residual_m.size()) {
        muted_text(theme, "The residual of " +
                              (state.scene_trial() ? state.scene_trial()->name : std::string("this trial")) +
                              " is not known: a trial of role validate is predicted once, when there is a verdict.");
        return;
    }
    const plot::Plot plot = residual_plot(context, row, axis_);
    const plot::PlotResult result = plot::draw_plot(plot, ImGui::GetContentRegionAvail(), theme, context.items, time_,
                                                    plot_, hidden_);
    if (result.cursor) context.emit(commands::SetTime{*result.cursor});
}

/// The missing force of the trial in which it was reconstructed.
void DiagnosePanel::draw_force(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const commands::ForceCourses& force = state.diagnosis->missing_force;
    // The largest amplitude decides the unit of the whole plot.
    double largest = 0.0;
    for (const Eigen::VectorXd& amplitude : force.amplitude_N)
        if (amplitude.size() > 0) largest = std::max(largest, amplitude.cwiseAbs().maxCoeff());
    // Millinewtons below 0.1 N, so that tick labels stay short.
    const bool small = largest < 0.1;
    plot::Plot plot;
    plot.id = "diagnose/plot";
    plot.panel.y = {.label = "missing in " + force.trial, .unit = small ? "mN" : "N", .include_zero = true};
    plot.cursor = state.time_s;
    plot.panel.vertical = {{0.0, ""}};
    plot.legend = true;
    const std::array<ImVec4, 3> colors{theme.force, theme.simulated, theme.success};
    for (std::size_t k = 0; k < force.amplitude_N.size(); ++k)
        plot.panel.series.push_back(plot::plot_series(
            force.names[k], force.time_s, (small ? 1e3 : 1.0) * force.amplitude_N[k], colors[k % colors.size()]));
    const plot::PlotResult result = plot::draw_plot(plot, ImGui::GetContentRegionAvail(), theme, context.items, time_,
                                                    plot_, hidden_);
    if (result.cursor) context.emit(commands::SetTime{*result.cursor});
}

/// Before and after, in millimetres and in units of the noise. An error that decreased is drawn in the success colour.
void DiagnosePanel::draw_errors(PanelContext& context, const commands::DiagnosisRow& row) {
    const platform::Theme& theme = context.theme;
    if (row.kind == commands::DiagnosisRow::Kind::missing_force)
        return muted_text(theme, "The missing force is not a model: there is no prediction with it.");
    if (!ImGui::BeginTable("errors", 6,
                           ImGuiTableFlags_PadOuterX | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY |
                               ImGuiTableFlags_BordersOuterH))
        return;
    ImGui::TableSetupScrollFreeze(0, 1);
    set_up_errors(theme, row);
    for (std::size_t t = 0; t < context.state.diagnosis->trials.size(); ++t) error_row(context, row, t);
    ImGui::EndTable();
}

}  // namespace myo::ui::panels
