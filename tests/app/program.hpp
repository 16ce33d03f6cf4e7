#pragma once

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace myo::test {

/// What the built program did.
struct ProgramRun {
    int status = -1;                    // exit status; 128 + signal when it was killed
    std::string out;                    // standard output
    std::string err;                    // standard error
    double seconds_after_signal = 0.0;  // from the signal to the end, when one was sent
    int open_threads = 0;               // at the time of the signal: threads that did not block it
};

/// Runs `myoloop` with these arguments and no display. The test fails when it does not end within `limit_s`.
///
/// @param interrupt_when  sends `signal` as soon as this text stands in its standard error; empty: never
ProgramRun run_program(const std::vector<std::string>& arguments, const std::string& interrupt_when = {},
                       double limit_s = 240.0, int signal = SIGINT);

int count_lines(const std::string& text);
std::string content_of(const std::filesystem::path& path);

}  // namespace myo::test
