#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace myo::mesh {

/// Outcome of a child process.
struct ChildEnd {
    enum class How { exited, signalled, timed_out, cancelled, not_started };
    How how = How::not_started;  // exited: by itself; signalled: by a signal; timed_out, cancelled: killed
    int code = 0;                // exit status, signal number or errno, depending on `how`
};

/// Runs a program without input and output and waits for its end. After a timeout or cancellation the child is killed
/// and reaped before the function returns, so no zombie process remains.
///
/// @param cancelled  polled about a hundred times a second
/// @param waiting    called with the elapsed time [s] while waiting
ChildEnd run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments, double time_limit_s,
                   const std::function<bool()>& cancelled, const std::function<void(double)>& waiting);

}  // namespace myo::mesh
