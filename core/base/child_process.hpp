#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace myo {

/// A program to be run, and how.
struct ChildCall {
    std::filesystem::path program;
    std::vector<std::string> arguments = {};
    std::filesystem::path output = "/dev/null";    // receives standard output
    std::filesystem::path messages = "/dev/null";  // receives standard error
    double time_limit_s = std::numeric_limits<double>::infinity();
    /// After a cancellation the child gets SIGTERM, and SIGKILL so much later; 0: SIGKILL at once. With a grace the
    /// child has a process group of its own, so that an interrupt from the terminal does not reach it twice.
    double grace_s = 0.0;
};

/// Outcome of a child process.
struct ChildEnd {
    enum class How { exited, signalled, timed_out, cancelled, not_started };
    How how = How::not_started;  // exited: by itself; signalled: by a signal; timed_out, cancelled: ended by this call
    int code = 0;                // exit status, signal number or errno, depending on `how`
};

/// Runs a program without input and waits for its end. After a timeout or cancellation the child is ended and reaped
/// before the function returns, so no zombie process remains. Several threads may each run a child.
///
/// @param cancelled  polled about a hundred times a second
/// @param waiting    called with the elapsed time [s] while waiting; may be null
ChildEnd run_child(const ChildCall& call, const std::function<bool()>& cancelled,
                   const std::function<void(double)>& waiting = {});

}  // namespace myo
