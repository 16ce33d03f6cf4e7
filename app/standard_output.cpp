#include "standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <system_error>

namespace myo::app {
namespace {

// Standard output is global, and so is its state.
int first_failure = 0;

}  // namespace

void print_text(const std::string& text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!written && first_failure == 0) first_failure = errno;
}

void print_format(const char* format, ...) {
    // First pass for the length, second for the text: values can be of any length.
    std::va_list values, again;
    va_start(values, format);
    va_copy(again, values);
    const int size = std::vsnprintf(nullptr, 0, format, values);
    std::string text(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    va_end(values);
    print_text(text);
}

std::string output_failure() { return first_failure == 0 ? "" : std::generic_category().message(first_failure); }

void keep_closed_streams_closed() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
        // open() returns the lowest free descriptor, which is this one; it is opened in the unusable direction.
        const int placeholder = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        if (placeholder < 0) return;
    }
}

}  // namespace myo::app
