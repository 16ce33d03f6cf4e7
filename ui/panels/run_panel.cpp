#include "panels/run_panel.hpp"

#include <imgui.h>

#include <cmath>

#include "panels/check_marks.hpp"
#include "panels/job_text.hpp"
#include "panels/measure_panel.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {

/// The result itself; the controls are at the foot of the side panel.
void RunPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    if (!state.run) {
        if (!state.scene) {
            muted_text(context.theme, "No run yet.");
        } else {
            muted_text(context.theme, "Run simulates every trial with these settings.");
        }
        return;
    }
    draw_errors(context);
}

namespace {

/// Pause and Cancel of the running job.
void draw_job_buttons(PanelContext& context) {
    const commands::JobView& job = *context.state.job;
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - spacing);
    ImGui::BeginDisabled(job.cancelling);
    if (ImGui::Button((std::string(job.paused ? platform::icon::play : platform::icon::pause) +
                       (job.paused ? "  Resume" : "  Pause"))
                          .c_str(),
                      {width, 0.0f}))
        context.emit(commands::Pause{!job.paused});
    context.items.mark("run/pause");
    ImGui::SameLine();
    if (ImGui::Button((std::string(platform::icon::stop) + "  Cancel").c_str(), {width, 0.0f}))
        context.emit(commands::Cancel{});
    context.items.mark("run/cancel");
    ImGui::EndDisabled();
}

/// Name, progress and time of the running job, with buttons to pause and cancel it.
void draw_progress(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const commands::JobView& job = *state.job;
    std::string name = job.name;
    if (!state.queue.empty()) name += ", " + std::to_string(state.queue.size()) + " waiting";
    ImGui::TextUnformatted(name.c_str());
    ImGui::SameLine();
    right_aligned(time_text(job));
    ImGui::ProgressBar(static_cast<float>(job.fraction()), {-1.0f, 0.0f}, bar_text(job).c_str());
    context.items.mark("run/progress");
    // Count and message of the job in one line, separated by a dot if both exist.
    const std::string counted = counted_text(job);
    const std::string between = counted.empty() || job.progress.message.empty() ? "" : " \xc2\xb7 ";
    const std::string stage = stage_words(job);
    const std::string text = stage + (stage.empty() || counted.empty() ? "" : ", ") + counted + between +
                             readable_detail(job);
    muted_text(theme, text.empty() ? " "
                                   : elided_lines(text, ImGui::GetContentRegionAvail().x,
                                                  1));  // the buttons below must not move
    draw_job_buttons(context);
}

/// Shown before the run is started: the motion would grow without end.
void draw_instability(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const std::string scheme = state.integrator()->label, first = state.integrators.front().label;
    notice(context.theme, commands::LogLevel::warning,
           "Velocity force \xce\x9b = " + plot::value_label(state.settings.velocity_force_1_s, 3) +
               " 1/s is above \xce\x9b_crit = " + plot::value_label(*state.critical_velocity_force_1_s, 3) +
               " 1/s of " + scheme + " at " + plot::value_label(state.damping_frequency_Hz, 3) +
               " Hz and time step h = " + plot::value_label(1e3 * state.settings.time_step_s, 3) +
               " ms: the motion will grow without bound. Try a smaller \xce\x9b, or none with " + first + ".");
    context.items.mark("run/unstable");
}

}  // namespace

/// From top to bottom: progress of the running job, a warning if the motion would be unstable, and the buttons. Run and
/// Calibrate can also be pressed while a job runs; the request then waits.
void draw_run_controls(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    if (state.job) draw_progress(context);
    if (state.is_unstable()) draw_instability(context);
    const bool can_calibrate = state.scene && !state.scene->calibrated.empty();
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - spacing);
    // The tooltips say that a request will wait.
    const std::string later = state.job ? "Waits until " + state.job->name + " has ended." : "";
    ImGui::BeginDisabled(!state.scene);
    const std::string run_label = std::string(platform::icon::play) + "  Run";
    // While a job runs, Run queues another one; then it is not the main action.
    if (state.job ? ImGui::Button(run_label.c_str(), {width, 0.0f}) : primary_button(theme, run_label, {width, 0.0f}))
        context.emit(commands::Run{});
    context.items.mark("run/run");
    tooltip(theme, "Simulates every trial (Ctrl+R). " + later);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!can_calibrate);
    if (ImGui::Button((std::string(platform::icon::target) + "  Calibrate").c_str(), {width, 0.0f}))
        context.emit(commands::Calibrate{});
    context.items.mark("run/calibrate");
    ImGui::EndDisabled();
    if (!can_calibrate) return;
    // The tooltip lists the parameters that a calibration changes.
    std::string what = "Fits to the measured markers:";
    for (const std::string& label : state.scene->calibrated) what += "\n\xc2\xb7 " + label;
    tooltip(theme, what + (later.empty() ? "" : "\n" + later));
}

void RunPanel::draw_errors(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    checks_line(context, state.run->checks, "run/checks");
    // Without markers there is no error to show.
    if (std::isfinite(state.run->rms_m)) {
        heading(theme, "Error against the markers");
        // Neither a preview nor the best iterate of a search is a result: all rows are of the last run.
        draw_trial_errors(context, "run/trial/", state.run.get());
        text_row(theme, "All trials", plot::millimetres(state.run->rms_m) + " rms");
    }
    text_row(theme, "Time taken", duration_label(state.run->seconds));
    // Messages come last, so that they move nothing.
    if (!state.run->problem.empty()) notice(theme, commands::LogLevel::warning, state.run->problem);
    for (const std::string& warning : state.run->warnings) notice(theme, commands::LogLevel::warning, warning);
}

}  // namespace myo::ui::panels
