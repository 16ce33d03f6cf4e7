#pragma once

#include <string>
#include <vector>

#include "commands/marker_errors.hpp"
#include "commands/workbench_state.hpp"

namespace myo {

/// The shown marker's way in an ended job that is drawn beside the shown run.
struct ComparedMarker {
    std::size_t record = 0;                          // in the history
    std::string name;                                // "Simulate 14:05:09"
    const Eigen::Matrix3Xd* position_m = nullptr;    // 3 x T, at the times of the shown trial; owned by the job's run
};

/// Of every compared job whose run has the shown trial at the same times; the shown run itself is left out.
std::vector<ComparedMarker> compared_markers(const WorkbenchState& state);

/// The curves of the shown marker for first_s <= time <= last_s as a table with a heading, comma separated, [s] and [m].
///
/// Columns: time_s, then x, y, z each of measured; of simulated and of residual = simulated less measured, when there is a run;
/// of every compared run. Nothing was seen or simulated: nan. Asserts that a trial and a marker are shown.
std::string marker_curves_csv(const WorkbenchState& state, double first_s, double last_s);

/// rms, largest distance, rms and bias per axis [m] and the share of samples seen, one line per marker; nan where nothing can be compared.
std::string marker_errors_csv(const std::vector<MarkerError>& errors);

}  // namespace myo
