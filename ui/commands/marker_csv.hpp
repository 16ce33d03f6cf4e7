#pragma once

#include <set>
#include <string>
#include <vector>

#include "commands/marker_errors.hpp"
#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// The shown marker's way in an ended job that is drawn beside the shown run.
struct ComparedMarker {
    std::size_t record = 0;                        // in the history
    std::string name;                              // "Simulate 14:05:09"
    const Eigen::Matrix3Xd* position_m = nullptr;  // 3 x T, at the times of the shown trial; owned by the job's run
};

/// Of every compared job whose run has the shown trial at the same times; the shown run itself is left out.
std::vector<ComparedMarker> compared_markers(const WorkbenchState& state);

/// The shown marker in another trial than the shown one, to be drawn over it in time since each trial's start.
struct OverlaidMarker {
    std::size_t trial = 0;                          // of the scene
    const SceneTrial* measured = nullptr;           // owned by the scene
    const Eigen::Matrix3Xd* simulated_m = nullptr;  // 3 x T at its times, in the shown run; null: none
};

/// Of these trials of the scene; the shown one and those without the shown marker are left out.
std::vector<OverlaidMarker> overlaid_markers(const WorkbenchState& state, const std::set<int>& trials);

/// The curves of the shown marker for first_s <= time <= last_s as a table with a heading, comma separated, [s] and
/// [m].
///
/// Columns: time_s, then x, y, z each of measured; of simulated and of residual = simulated less measured, when there
/// is a run; of every compared run; of every overlaid trial as of the shown one. The lines are the times of all these
/// trials together; where a trial has no sample at a time, or nothing was seen or simulated: nan. Asserts that a trial
/// and a marker are shown.
std::string marker_curves_csv(const WorkbenchState& state, double first_s, double last_s,
                              const std::set<int>& overlaid = {});

/// rms, largest distance, rms, largest and bias per axis [m] and the share of samples seen, one line per marker; nan
/// where nothing can be compared.
std::string marker_errors_csv(const std::vector<MarkerError>& errors);

}  // namespace myo::ui::commands
