#pragma once

#include <string>
#include <vector>

namespace myo::ui::commands {

/// Repairs of a trial's recording by hand, for the window.
struct TraceRepairs {
    bool possible = false;          // the trial has a recording that is shown sample by sample
    double start_s = 0.0;           // time in the recording at t = 0
    std::vector<std::string> made;  // in their order, in words with times of the trial
};

}  // namespace myo::ui::commands
