#pragma once

#include <functional>
#include <string>

namespace myo::app {

/// Result of work in a child process.
struct OwnProcessResult {
    std::string output;              // text that the work returned
    long peak_bytes_over_start = 0;  // peak memory above that at the start
    bool crashed = false;
};

/// Runs `work` in a child process, so that its peak memory is measured separately. Must be called before threads are
/// started, because fork() copies only the calling thread.
OwnProcessResult run_in_own_process(const std::function<std::string()>& work);

}  // namespace myo::app
