#include "commands/live_preview.hpp"

#include <algorithm>
#include <cmath>

#include "commands/workbench_state.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::commands {

double preview_length_s(const WorkbenchState& state) {
    constexpr double usual_s = 0.5;  // default length
    const double asked = state.preview.length_s.value_or(usual_s);
    const SceneTrial* const trial = state.scene_trial();
    // Not beyond the last sample: there is nothing to compare with.
    return trial && trial->time_s.size() > 0 ? std::min(asked, trial->time_s[trial->time_s.size() - 1]) : asked;
}

std::string preview_text(const WorkbenchState& state) {
    const LivePreview& preview = state.preview;
    // What matters most comes first: a failure, the run that is shown, what it waits for, what to do.
    if (!preview.on) return "";
    if (!preview.problem.empty()) return "Preview failed: " + preview.problem;
    const std::string from_0_to = "Preview 0\xe2\x80\x93";
    // A run with a problem still has frames up to it, so both are mentioned.
    if (const SimulatedTrial* const trial = state.trial_of(preview.run.get())) {
        const std::string error = std::isfinite(trial->rms_m)
                                      ? ", rms error " + plot::value_label(1e3 * trial->rms_m, 3) + " mm"
                                      : "";
        const std::string problem = preview.run->problem.empty() ? "" : ": " + preview.run->problem;
        return from_0_to + plot::plain_label(preview.end_s, 3) + " s" + error + problem +
               (preview.working ? ", running\xe2\x80\xa6" : "");
    }
    if (preview.working)
        return from_0_to + plot::plain_label(preview_length_s(state), 3) +
               (state.busy() ? " s waits until " + state.job->name + " has ended" : " s, running\xe2\x80\xa6");
    if (state.body && !state.mesh_is_current()) return "Build the mesh to preview";
    return "Change a value to preview it";
}

}  // namespace myo::ui::commands
