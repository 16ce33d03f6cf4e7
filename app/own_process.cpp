#include "own_process.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>

#include "interrupt.hpp"

namespace myo::app {
namespace {

/// Resident memory now [bytes], from the second number of /proc/self/statm.
long resident_bytes() {
    std::ifstream file("/proc/self/statm");
    long total = 0, resident = 0;
    file >> total >> resident;
    return resident * sysconf(_SC_PAGESIZE);
}

/// Writes a text to a pipe, in pieces if necessary. A failure leaves it incomplete, which the parent takes for a crash.
void write_all(int descriptor, const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t count = write(descriptor, text.data() + at, text.size() - at);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return;
        at += static_cast<std::size_t>(count);
    }
}

}  // namespace

OwnProcessResult run_in_own_process(const std::function<std::string()>& work) {
    OwnProcessResult result;
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) {
        result.crashed = true;
        return result;
    }
    // The child returns its peak memory and its text through a pipe; _exit() skips destructors of the parent's objects.
    const pid_t child = fork();
    if (child == 0) {
        take_terminations_again();
        close(ends[0]);
        const long start = resident_bytes();
        const std::string text = work();
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        // Linux gives ru_maxrss in KiB. The child inherits the pages of the parent, which do not count.
        write_all(ends[1], std::to_string(usage.ru_maxrss * 1024 - start) + "\n" + text);
        _exit(0);
    }
    // The parent's writing end must be closed, or read() below would wait for it for ever.
    close(ends[1]);
    std::string text;
    std::array<char, 4096> buffer{};
    // Read until the child closes its end: a pipe holds less than the text.
    while (child > 0) {
        const ssize_t count = read(ends[0], buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    close(ends[0]);
    int status = 0;
    if (child > 0) waitpid(child, &status, 0);
    const std::size_t line = text.find('\n');
    // A child that was killed has written no complete answer.
    result.crashed = child <= 0 || status != 0 || line == std::string::npos;
    if (result.crashed) return result;
    result.peak_bytes_over_start = std::stol(text.substr(0, line));
    result.output = text.substr(line + 1);
    return result;
}

}  // namespace myo::app
