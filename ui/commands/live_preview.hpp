#pragma once

#include <memory>
#include <optional>
#include <string>

#include "commands/run_result.hpp"

namespace myo::ui::commands {

struct WorkbenchState;

/// The live preview: a short run of the shown trial after every edit of the settings. It is shown and replaced by the
/// next one; it is neither a job nor a result.
struct LivePreview {
    bool on = false;
    std::optional<double> length_s;  // length that the user chose; empty: chosen for the trial
    bool working = false;            // newer settings are being simulated, or wait for a job to end
    // Run of the newest settings that are ready; only the shown trial has frames. Null: none.
    std::shared_ptr<const RunResult> run;
    double end_s = 0.0;   // end of `run` in the trial [s]
    std::string problem;  // why the newest settings failed; empty: they did not, or are not ready
};

/// Length of the preview [s]: what the user chose, by default half a second; at most the length of the trial.
double preview_length_s(const WorkbenchState& state);

/// State of the preview as text: "Preview 0–0.5 s, rms error 4.9 mm", or what it waits for. Empty while it is off.
std::string preview_text(const WorkbenchState& state);

}  // namespace myo::ui::commands
