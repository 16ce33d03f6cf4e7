#include "base/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

#include "base/stopwatch.hpp"

namespace myo {
namespace {

/// Starts a child; returns 0 or errno.
int spawn(const ChildCall& call, pid_t& child) {
    std::vector<std::string> words{call.program.string()};
    words.insert(words.end(), call.arguments.begin(), call.arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    constexpr int written = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, call.output.c_str(), written, 0666);
    posix_spawn_file_actions_addopen(&actions, 2, call.messages.c_str(), written, 0666);
    // An inherited socket or pipe would keep its other end open as long as the child runs.
    posix_spawn_file_actions_addclosefrom_np(&actions, 3);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // What this program blocks, a child would never hear.
    sigset_t nothing;
    sigemptyset(&nothing);
    posix_spawnattr_setsigmask(&attributes, &nothing);
    const int group = call.grace_s > 0.0 ? POSIX_SPAWN_SETPGROUP : 0;
    posix_spawnattr_setflags(&attributes, static_cast<short>(POSIX_SPAWN_SETSIGMASK | group));
    const int failure = posix_spawn(&child, call.program.c_str(), &actions, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
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

ChildEnd run_child(const ChildCall& call, const std::function<bool()>& cancelled,
                   const std::function<void(double)>& waiting) {
    pid_t child = 0;
    if (const int failure = spawn(call, child); failure != 0) return {ChildEnd::How::not_started, failure};

    const Stopwatch watch;
    std::optional<double> asked_s;  // when the child was asked to end
    // Short work takes milliseconds: the polling interval grows from 1 to 10 ms.
    auto pause = std::chrono::milliseconds(1);
    for (;;) {
        int status = 0;
        const pid_t done = collect(child, status, WNOHANG);
        if (done == child && asked_s) return {ChildEnd::How::cancelled, 0};
        if (done == child && WIFEXITED(status)) return {ChildEnd::How::exited, WEXITSTATUS(status)};
        if (done == child && WIFSIGNALED(status)) return {ChildEnd::How::signalled, WTERMSIG(status)};
        if (done < 0) return {ChildEnd::How::not_started, errno};

        const double seconds = watch.seconds();
        const bool stop = asked_s || cancelled();
        if (stop && !asked_s && call.grace_s > 0.0) {
            asked_s = seconds;
            kill(child, SIGTERM);
        }
        const bool out_of_grace = stop && !(asked_s && seconds < *asked_s + call.grace_s);
        if (out_of_grace || seconds > call.time_limit_s) {
            // SIGKILL cannot be ignored, so the following wait ends.
            kill(child, SIGKILL);
            collect(child, status, 0);
            return {stop ? ChildEnd::How::cancelled : ChildEnd::How::timed_out, 0};
        }
        if (waiting) waiting(seconds);
        std::this_thread::sleep_for(pause);
        pause = std::min(pause + std::chrono::milliseconds(1), std::chrono::milliseconds(10));
    }
}

}  // namespace myo
