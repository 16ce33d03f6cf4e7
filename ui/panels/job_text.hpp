#pragma once

#include <string>

#include "commands/job.hpp"

// Progress of a running job in words.

namespace myo::ui::panels {

/// Progress as a count: "12 of 40 evaluations". Empty if nothing is counted.
std::string counted_text(const commands::JobView& job);

/// Name of the present part of a job, "Other moduli"; empty while it does what the job is named after.
std::string stage_words(const commands::JobView& job);

/// Detail of the progress, such as the effect that is tried, without the underscores of ids.
std::string readable_detail(const commands::JobView& job);

/// Remaining time: "30 to 60 s left"; for a job in several parts only that of the present part, "at most 40 s left of
/// this phase" for evaluations, whose number is limited only; the time so far if no estimate exists; "paused" or
/// "stopping".
std::string time_text(const commands::JobView& job);

/// Text in the progress bar: "35 %", or "working" if the total is unknown.
std::string bar_text(const commands::JobView& job);

/// Range of the time that is left, for an extrapolation of it [s]: "2 to 4 min", "less than 10 s".
std::string time_left_range(double seconds);

}  // namespace myo::ui::panels
