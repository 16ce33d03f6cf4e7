#include "mesh/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "base/stopwatch.hpp"

namespace myo::mesh {
namespace {

/// Starts a child with standard streams on /dev/null; returns 0 or errno.
int spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments, pid_t& child) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    // An inherited socket or pipe would keep its other end open as long as the child runs.
    posix_spawn_file_actions_addclosefrom_np(&actions, 3);
    const int failure = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure;
}

/// waitpid() repeated after signals.
pid_t collect(pid_t child, int& status, int options) {
    pid_t done = 0;
    do done = waitpid(child, &status, options);
    while (done < 0 && errno == EINTR);
    return done;
}

}  // namespace

ChildEnd run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments, double time_limit_s,
                   const std::function<bool()>& cancelled, const std::function<void(double)>& waiting) {
    pid_t child = 0;
    if (const int failure = spawn(program, arguments, child); failure != 0)
        return {ChildEnd::How::not_started, failure};

    const Stopwatch watch;
    // Small meshes take milliseconds: the polling interval grows from 1 to 10 ms.
    auto pause = std::chrono::milliseconds(1);
    for (;;) {
        int status = 0;
        const pid_t done = collect(child, status, WNOHANG);
        if (done == child && WIFEXITED(status)) return {ChildEnd::How::exited, WEXITSTATUS(status)};
        if (done == child && WIFSIGNALED(status)) return {ChildEnd::How::signalled, WTERMSIG(status)};
        if (done < 0) return {ChildEnd::How::not_started, errno};

        const double seconds = watch.seconds();
        const bool stop = cancelled();
        if (stop || seconds > time_limit_s) {
            // SIGKILL cannot be ignored, so the following wait ends.
            kill(child, SIGKILL);
            collect(child, status, 0);
            return {stop ? ChildEnd::How::cancelled : ChildEnd::How::timed_out, 0};
        }
        waiting(seconds);
        std::this_thread::sleep_for(pause);
        pause = std::min(pause + std::chrono::milliseconds(1), std::chrono::milliseconds(10));
    }
}

}  // namespace myo::mesh
