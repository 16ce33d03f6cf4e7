#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace myo::mesh {

/// How a child process ended.
struct ChildEnd {
    enum class How { exited, signalled, timed_out, cancelled, not_started };
    How how = How::not_started;
    int code = 0;  // exit status, signal number, or errno
};

/// Runs a program without input and output and waits for it, asking `cancelled` a hundred times a second. On time-out
/// and cancel the child is killed and collected before this returns: never a zombie. `waiting` is told the seconds so
/// far.
ChildEnd run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments, double time_limit_s,
                   const std::function<bool()>& cancelled, const std::function<void(double)>& waiting);

}  // namespace myo::mesh
