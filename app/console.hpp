#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "base/throttle.hpp"

namespace myo::app {

/// Output of a command: results to standard output, progress and problems to standard error. Thread-safe.
///
/// Progress is a bar with the remaining time on a terminal, JSON lines on request, and nothing otherwise.
class Console {
public:
    /// @param quiet          prints errors only
    /// @param json_progress  progress as JSON lines, also without a terminal
    Console(bool quiet, bool json_progress);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Progress that reports to this console and is cancelled by Ctrl-C. The console must outlive it.
    Progress progress();

    /// Prints a result on standard output; nothing if quiet.
    void print(const std::string& text);

    /// Prints "myoloop: warning: ..." on standard error; nothing if quiet.
    void warn(const std::string& text);

    /// Prints "myoloop: ..." as one line on standard error, even if quiet.
    void complain(const std::string& text);

    /// Reports wrong input; returns status_wrong.
    int refuse(const Error& error);

    /// Reports that results cannot be written; returns status_failed.
    int fail(const Error& error);

private:
    // Draws a progress event; called from worker threads.
    void show(const ProgressEvent& event);
    // Erases the bar, so that a message does not follow it in one line. Requires the lock.
    void clear_bar();

    using Clock = std::chrono::steady_clock;

    bool quiet_;
    bool json_progress_;
    // Standard error is a terminal.
    bool terminal_;
    // Guards output and the members below.
    std::mutex mutex_;
    // Task of the bar and the time of its first report: a new task begins a new estimate of what is left.
    std::string task_;
    Clock::time_point task_start_;
    Throttle throttle_;
    bool bar_shown_ = false;
};

/// A progress event as JSON line: {"event":"progress","task":...,"done":...,"total":...,"unit":...,"message":...}
std::string progress_line(const ProgressEvent& event);

/// Progress bar: "[#####     ]  45 %  1.20 of 2.50 s  8 s left"; for a fit "evaluation 4 [#####     ]  45 %  12 s so
/// far, at most 3 min 02 s left".
///
/// @param elapsed_s  time since the task began
std::string progress_bar(const ProgressEvent& event, double elapsed_s);

}  // namespace myo::app
