#pragma once

#include <memory>
#include <optional>
#include <string>

#include "commands/run_result.hpp"

namespace myo::ui::commands {

struct WorkbenchState;

/// Short runs of the shown trial that follow every edit of the settings. They are looked at and forgotten: no job, no
/// result.
struct LivePreview {
    bool on = false;
    std::optional<double> length_s;  // asked for; empty: chosen for the trial
    bool working = false;            // newer settings are being run, or wait for a job to end
    std::shared_ptr<const RunResult>
        run;              // of the newest settings that are ready, only the shown trial with frames; null: none
    double end_s = 0.0;   // of `run`
    std::string problem;  // why the newest settings could not be run; empty: they could, or it is not known yet
};

/// How much of the shown trial is previewed [s]: what was asked for, or half a second, but never more than there is.
double preview_length_s(const WorkbenchState& state);

/// "Preview 0–0.5 s, rms error 4.9 mm", or what a preview waits for; empty while it is off.
std::string preview_text(const WorkbenchState& state);

}  // namespace myo::ui::commands
