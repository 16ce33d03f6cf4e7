#pragma once

#include <functional>
#include <string>

namespace myo::app {

/// Result of work in a child process.
struct OwnProcessResult {
    // Empty after a crash.
    std::string output;              // text that the work returned
    long peak_bytes_over_start = 0;  // peak memory above that at the start
    bool crashed = false;
};

/// Runs `work` in a child process and waits for its end, so that its peak memory is measured separately and a crash
/// does not end the program. What the work changes in memory is lost; its text comes back.
///
/// Must be called before threads are started, because fork() copies only the calling thread.
/// Errors: `crashed` if no process can be made, or if the work ended it or was killed.
OwnProcessResult run_in_own_process(const std::function<std::string()>& work);

}  // namespace myo::app
