#pragma once

#include <string>

#include "commands/job.hpp"

// What a running job tells of itself, in words.

namespace myo::ui::panels {

/// "12 of 40 evaluations"; empty while nothing is counted.
std::string counted_words(const commands::JobView& job);

/// "40 s left", "at most 40 s left", "40 s left of this stage"; how long it has gone on while that cannot be told.
std::string time_words(const commands::JobView& job);

/// What stands in its bar: "35 %", or "working" where its end is not known.
std::string bar_words(const commands::JobView& job);

}  // namespace myo::ui::panels
