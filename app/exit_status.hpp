#pragma once

namespace myo::app {

/// Exit status of the program. Bad input and a failed computation differ, so that scripts can react to them.
enum ExitStatus : int {
    status_done = 0,
    status_failed = 1,     // the computation failed
    status_wrong = 2,      // wrong call or input
    status_stopped = 130,  // interrupted by the user, as shells report it
};

}  // namespace myo::app
