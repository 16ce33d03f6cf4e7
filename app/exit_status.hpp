#pragma once

namespace myo::app {

/// What the program returns to its caller.
enum ExitStatus : int {
    status_done = 0,
    status_failed = 1,     // the computation failed
    status_wrong = 2,      // the call or the input is wrong
    status_stopped = 130,  // by the user, as a shell says it
};

}  // namespace myo::app
