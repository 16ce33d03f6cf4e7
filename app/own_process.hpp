#pragma once

#include <functional>
#include <string>

namespace myo::app {

/// What a piece of work left when it ran in a process of its own.
struct OwnProcessResult {
    std::string output;              // what it returned
    long peak_bytes_over_start = 0;  // most memory it held beyond what it started with
    bool crashed = false;
};

/// Runs `work` in a child process, so that its peak of memory is its own, and returns its text. Call before threads are
/// started.
OwnProcessResult run_in_own_process(const std::function<std::string()>& work);

}  // namespace myo::app
