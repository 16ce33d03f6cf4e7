#pragma once

#include <string>

namespace myo::app {

/// Writes to standard output at once; what keeps it from being written is remembered for output_failure().
void print_text(const std::string& text);

/// As std::printf, with print_text().
[[gnu::format(printf, 1, 2)]] void print_format(const char* format, ...);

/// The system's first reason why standard output could not be written, as "No space left on device"; empty: there was
/// none.
std::string output_failure();

/// Puts something unusable in the place of standard streams that are closed: else the next file that is opened would be
/// in their place, and would get what is printed. To be called before any file is opened.
void keep_closed_streams_closed();

}  // namespace myo::app
