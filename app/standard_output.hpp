#pragma once

#include <string>

namespace myo::app {

/// Writes to standard output and flushes; the first failure is stored for output_failure(). Not thread-safe: Console
/// holds a lock.
void print_text(const std::string& text);

/// std::printf() by print_text().
[[gnu::format(printf, 1, 2)]] void print_format(const char* format, ...);

/// First reason why standard output could not be written, e.g. "No space left on device"; empty if none.
std::string output_failure();

/// Opens an unusable placeholder for each closed standard stream: otherwise the next opened file would take its
/// descriptor and receive what is printed. To be called before any file is opened.
void keep_closed_streams_closed();

}  // namespace myo::app
