#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "base/throttle.hpp"

namespace myo::app {

/// Where a command speaks: results to standard output, progress and problems to standard error.
///
/// Progress is a bar with the time left on a terminal, JSON lines when asked for, and nothing otherwise.
class Console {
public:
    Console(bool quiet, bool json_progress);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Reports here and stops on Ctrl-C. The console must outlive it.
    Progress progress();

    /// A result, on standard output; nothing when quiet.
    void print(const std::string& text);

    /// "myoloop: warning: ...", on standard error; nothing when quiet.
    void warn(const std::string& text);

    /// "myoloop: ...", one line on standard error, even when quiet.
    void complain(const std::string& text);

    /// Says what is wrong with the input; the exit status.
    int refuse(const Error& error);

    /// Says why results cannot be written; the exit status.
    int fail(const Error& error);

private:
    void show(const ProgressEvent& event);
    void clear_bar();

    using Clock = std::chrono::steady_clock;

    bool quiet_;
    bool json_progress_;
    bool terminal_;
    std::mutex mutex_;
    std::string task_;
    Clock::time_point task_start_;
    Throttle throttle_;
    bool bar_shown_ = false;
};

/// A progress event as one line: {"event":"progress","task":...,"done":...,"total":...,"unit":...,"message":...}
std::string progress_line(const ProgressEvent& event);

/// "[#####     ]  45 %  1.20 of 2.50 s  8 s left"; of a fit "evaluation 4 [#####     ]  45 %  12 s so far, at most 3
/// min 02 s left".
std::string progress_bar(const ProgressEvent& event, double elapsed_s);

}  // namespace myo::app
