#include "panels/run_panel.hpp"

#include <imgui.h>

#include <cmath>

#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/ticks.hpp"

namespace myo {
namespace {

std::string millimetres(double metres) { return value_label(1e3 * metres, 3); }

void right_aligned(const std::string& text) {
    const float space = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (space > 0.0f) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + space);
    ImGui::TextUnformatted(text.c_str());
}

void heading(const Theme& theme, const char* text) {
    ImGui::Spacing();
    ImGui::PushFont(theme.strong);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

}  // namespace

std::string duration_label(double seconds) {
    const long whole = std::lround(std::max(0.0, seconds));
    if (whole < 60) return std::to_string(whole) + " s";
    if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

std::string RunPanel::title() const { return std::string(icon::done) + "  Result"; }

void RunPanel::draw(PanelContext& context) {
    const WorkbenchState& state = context.state;
    if (!state.run) {
        if (!state.scene || !state.scene->cannot_run.empty()) {
            muted_text(context.theme, "Nothing has been run.");
        } else {
            muted_text(context.theme, "Run simulates every trial with these settings. Calibrate fits the settings to the markers.");
        }
        return;
    }
    if (!state.run_is_current() && !state.busy()) {
        notice(context.theme, LogLevel::information, "The settings changed since this run.");
        context.items.mark("run/outdated");
    }
    draw_calibration(context);
    draw_errors(context);
}

void draw_run_controls(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const Theme& theme = context.theme;
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    if (state.job) {
        const JobView& job = *state.job;
        ImGui::TextUnformatted(job.name.c_str());
        const std::string left = job.cancelling ? "stopping" : job.remaining_s ? duration_label(*job.remaining_s) + " left" : duration_label(job.elapsed_s);
        ImGui::SameLine();
        right_aligned(left);
        // A job that does not know its end shows activity instead of a part.
        const std::string inside = job.progress.total > 0.0 ? value_label(100.0 * job.fraction(), 2) + " %" : "working";
        ImGui::ProgressBar(static_cast<float>(job.fraction()), {-1.0f, 0.0f}, inside.c_str());
        context.items.mark("run/progress");
        std::string counted;
        if (job.progress.total > 0.0 && !job.progress.unit.empty())
            counted = with_separators(job.progress.done) + " of " + with_separators(job.progress.total) + " " + job.progress.unit;
        const std::string between = counted.empty() || job.progress.message.empty() ? "" : " \xc2\xb7 ";
        const std::string text = counted + between + job.progress.message;
        muted_text(theme, text.empty() ? " " : text);   // the button below stays where it is
        ImGui::BeginDisabled(job.cancelling);
        if (ImGui::Button((std::string(icon::stop) + "  Cancel").c_str(), {-1.0f, 0.0f})) context.emit(command::Cancel{});
        context.items.mark("run/cancel");
        ImGui::EndDisabled();
        return;
    }
    if (state.is_unstable()) {
        const std::string scheme = state.integrator()->label, first = state.integrators.front().label;
        notice(theme, LogLevel::warning, "\xce\x9b = " + value_label(state.settings.velocity_force_1_s, 3) + " 1/s is above \xce\x9b_crit = " +
                                             value_label(*state.critical_velocity_force_1_s, 3) + " 1/s of " + scheme + " at " +
                                             value_label(state.damping_frequency_Hz, 3) + " Hz and h = " + value_label(1e3 * state.settings.time_step_s, 3) +
                                             " ms: the motion will grow without end. Try a smaller \xce\x9b, or none with " + first + ".");
        context.items.mark("run/unstable");
    }
    const bool runnable = state.scene && state.scene->cannot_run.empty();
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - spacing);
    ImGui::BeginDisabled(!runnable);
    if (primary_button(theme, std::string(icon::play) + "  Run", {width, 0.0f})) context.emit(command::Run{});
    context.items.mark("run/run");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!runnable || state.scene->calibrated.empty());
    if (ImGui::Button((std::string(icon::target) + "  Calibrate").c_str(), {width, 0.0f})) context.emit(command::Calibrate{});
    context.items.mark("run/calibrate");
    if (runnable && !state.scene->calibrated.empty() && ImGui::IsItemHovered()) {
        std::string what = "Fits to the measured markers:";
        for (const std::string& label : state.scene->calibrated) what += "\n\xc2\xb7 " + label;
        ImGui::SetTooltip("%s", what.c_str());
    }
    ImGui::EndDisabled();
}

void RunPanel::draw_calibration(PanelContext& context) {
    const auto& calibration = context.state.calibration;
    if (!calibration) return;
    heading(context.theme, calibration->stopped ? "Calibration, stopped" : "Calibrated");
    for (const ParameterRow& row : calibration->parameters) {
        text_row(context.theme, row.name, label_with_deviation(row.value, row.deviation) + " " + row.unit + "\nfrom " +
                                              plain_label(row.start, 4) + " " + row.unit);
    }
    text_row(context.theme, "rms error", millimetres(calibration->rms_before_m) + " \xe2\x86\x92 " + millimetres(calibration->rms_after_m) + " mm");
}

void RunPanel::draw_errors(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const Theme& theme = context.theme;
    if (!state.run->problem.empty()) notice(theme, LogLevel::warning, state.run->problem);
    for (const std::string& warning : state.run->warnings) notice(theme, LogLevel::warning, warning);
    if (!std::isfinite(state.run->rms_m)) {
        text_row(theme, "Time taken", duration_label(state.run->seconds));
        return;
    }
    heading(theme, "Error against the markers");
    if (ImGui::BeginTable("errors", 3, ImGuiTableFlags_PadOuterX | ImGuiTableFlags_RowBg)) {
        ImGui::TableSetupColumn("Trial", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("Role", ImGuiTableColumnFlags_WidthFixed);
        ImGui::TableSetupColumn("rms [mm]", ImGuiTableColumnFlags_WidthFixed);
        ImGui::PushStyleColor(ImGuiCol_Text, theme.muted);
        ImGui::TableNextRow();
        for (const char* title : {"Trial", "Role", "rms [mm]"}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(title);
        }
        ImGui::PopStyleColor();
        for (std::size_t t = 0; t < state.run->trials.size() && t < state.scene->trials.size(); ++t) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            const std::string label = state.run->trials[t].name;
            ImGui::PushID(static_cast<int>(t));
            if (ImGui::Selectable(label.c_str(), static_cast<int>(t) == state.trial, ImGuiSelectableFlags_SpanAllColumns)) {
                context.emit(command::ChooseTrial{static_cast<int>(t)});
            }
            context.items.mark("run/trial/" + label);
            ImGui::PopID();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(state.scene->trials[t].role.c_str());
            ImGui::TableNextColumn();
            right_aligned(millimetres(state.run->trials[t].rms_m));
        }
        ImGui::EndTable();
    }
    text_row(theme, "All trials", millimetres(state.run->rms_m) + " mm rms");
    text_row(theme, "Time taken", duration_label(state.run->seconds));
}

}  // namespace myo
