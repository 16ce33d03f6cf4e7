#include "app/program.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

namespace myo::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

[[noreturn]] void become(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& out,
                         const fs::path& err) {
    const int to_out = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600),
              to_err = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(to_out, STDOUT_FILENO);
    ::dup2(to_err, STDERR_FILENO);
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    ::_exit(127);
}

/// Threads of a process that do not block a signal, by proc(5).
int open_threads(pid_t process, int signal) {
    int open = 0;
    for (const fs::directory_entry& thread : fs::directory_iterator("/proc/" + std::to_string(process) + "/task")) {
        const std::string status = content_of(thread.path() / "status"), key = "SigBlk:\t";
        const std::size_t at = status.find(key);
        if (at == std::string::npos) continue;  // it has just ended
        const unsigned long long blocked = std::stoull(status.substr(at + key.size(), 16), nullptr, 16);
        if ((blocked >> (signal - 1) & 1) == 0) ++open;
    }
    return open;
}

}  // namespace

std::string content_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

int count_lines(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

ProgramRun run_program(const std::vector<std::string>& arguments, const std::string& interrupt_when, double limit_s,
                       int signal) {
    const fs::path program = fs::path(MYOLOOP_BINARY_DIR) / "myoloop";
    static int calls = 0;
    const std::string stem = "myoloop_call_" + std::to_string(::getpid()) + "_" + std::to_string(calls++);
    const fs::path out = fs::path(::testing::TempDir()) / (stem + ".out"),
                   err = fs::path(::testing::TempDir()) / (stem + ".err");
    const Clock::time_point start = Clock::now();
    const pid_t child = ::fork();
    if (child == 0) become(program, arguments, out, err);

    ProgramRun run;
    Clock::time_point signalled = start;
    bool waiting_for_text = !interrupt_when.empty();
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (waiting_for_text && content_of(err).find(interrupt_when) != std::string::npos) {
            waiting_for_text = false;
            run.open_threads = open_threads(child, signal);
            signalled = Clock::now();
            ::kill(child, signal);
        }
        if (seconds_since(start) > limit_s) {
            ::kill(child, SIGKILL);
            ADD_FAILURE() << "the program did not end within " << limit_s << " s";
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    run.seconds_after_signal = seconds_since(signalled);
    EXPECT_FALSE(waiting_for_text) << "never saw: " << interrupt_when;
    run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.out = content_of(out);
    run.err = content_of(err);
    fs::remove(out);
    fs::remove(err);
    return run;
}

}  // namespace myo::test
