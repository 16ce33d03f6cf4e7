#pragma once

#include <set>
#include <string>
#include <vector>

#include "commands/marker_errors.hpp"
#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// The shown marker's path in an ended job that is drawn together with the shown run.
struct ComparedMarker {
    std::size_t record = 0;                        // index in the history
    std::string name;                              // "Simulate 14:05:09"
    const Eigen::Matrix3Xd* position_m = nullptr;  // 3 x T [m], at the times of the shown trial; owned by the job's run
};

/// One entry for each compared job whose run has the shown trial with the same sample times. The shown run itself is
/// left out. Empty if no trial is shown.
std::vector<ComparedMarker> compared_markers(const WorkbenchState& state);

/// The shown marker in another trial, drawn over the shown trial in time since each trial's start.
struct OverlaidMarker {
    std::size_t trial = 0;                          // index in the scene
    const SceneTrial* measured = nullptr;           // owned by the scene
    const Eigen::Matrix3Xd* simulated_m = nullptr;  // 3 x T [m] at its times, in the shown run; null: none
};

/// One entry for each of these trials. The shown trial and trials without the shown marker are left out.
///
/// @param trials  indices in the scene
std::vector<OverlaidMarker> overlaid_markers(const WorkbenchState& state, const std::set<int>& trials);

/// The curves of the shown marker between two times as CSV with a header, in seconds and metres.
///
/// Columns: time_s; then x, y, z each of measured; with a run of simulated and of residual = simulated - measured; of
/// every compared run; of every overlaid trial in the same way. One line for each sample time of any of these trials.
/// Cells are nan where a trial has no sample at that time, or the marker was not seen or not simulated.
///
/// @param first_s, last_s  range of times, ends included [s]
/// @param overlaid  indices of the other trials
/// Asserts that a trial and a marker are shown.
std::string marker_curves_csv(const WorkbenchState& state, double first_s, double last_s,
                              const std::set<int>& overlaid = {});

/// Marker errors as CSV, one line per marker: rms, largest distance, and per axis rms, largest and bias [m]; then the
/// share of samples seen. nan where nothing can be compared.
std::string marker_errors_csv(const std::vector<MarkerError>& errors);

}  // namespace myo::ui::commands
