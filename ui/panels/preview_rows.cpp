#include "panels/preview_rows.hpp"

#include <imgui.h>

#include <algorithm>

namespace myo::ui::panels {

namespace {

/// Longest preview of the shown trial [s]: there is nothing to compare with after its last sample.
double longest_preview_s(const commands::WorkbenchState& state) {
    constexpr double without_trial_s = 1e3;
    const commands::SceneTrial* const trial = state.scene_trial();
    return trial && trial->time_s.size() > 0 ? trial->time_s[trial->time_s.size() - 1] : without_trial_s;
}

/// State of the preview in a place of two lines, so that the rows below do not move while it is computed.
void draw_preview_state(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const commands::LivePreview& preview = state.preview;
    // A run may fail to start, or end early with frames up to the failure.
    const bool failed = !preview.problem.empty() || (preview.run && !preview.run->problem.empty());
    notice_in_place(context.theme, failed ? commands::LogLevel::warning : commands::LogLevel::information,
                    commands::preview_text(state), 2);
    context.items.mark("preview/state");
}

}  // namespace

void draw_preview_rows(PanelContext& context, NumberEdits& edit) {
    const commands::WorkbenchState& state = context.state;
    if (!state.scene) return;
    row_label(context.theme, "Live preview",
              "Every edit of a value starts a short run of the shown trial in the background: view and curves "
              "show it when it is ready. "
              "It is not a result; Run makes one.");
    bool on = state.preview.on;
    ImGui::PushID("live preview");
    // Switching keeps the length; an empty one stays the choice of the program.
    if (ImGui::Checkbox("##on", &on)) context.emit(commands::ChangePreview{on, state.preview.length_s});
    ImGui::PopID();
    context.items.mark("preview/on");
    if (!state.preview.on) return;
    const NumberField field{
        "Preview length",
        "preview/length",
        commands::Dimension::time,
        "s",
        "Seconds of the trial that are run, from t = 0 on: length / h steps. The shorter, the faster.",
        {0.01, std::max(0.01, longest_preview_s(state))},
        0.01,
        "preview length"};
    double length = commands::preview_length_s(state);
    bool goes_on = false;
    if (number_row(context, field, edit, length, goes_on)) context.emit(commands::ChangePreview{true, length});
    draw_preview_state(context);
}

}  // namespace myo::ui::panels
