#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "measurement/trace_reader.hpp"

namespace myo::measurement {

/// All readers, in the order in which a file is tried. A new one is a file of its own and one line in trace_file.cpp.
const std::vector<TraceReader>& trace_readers();

/// Reader with the given id; null if unknown.
const TraceReader* find_trace_reader(const std::string& id);

/// Ids of all readers.
std::vector<std::string> trace_formats();

/// Endings of the files of all readers, each once.
std::vector<std::string> trace_endings();

/// Whether a path ends like a recording, in any case of letters.
bool has_trace_ending(const std::filesystem::path& path);

/// Reads a recording with the reader of its format, which must be known.
/// Errors: those of the reader.
Result<Recording> read_trace(const std::filesystem::path& path, const TraceSource& source);

/// Detects the format of a file from its content.
///
/// For a table without header also the separator and the number of markers, which are named "marker 1", "marker 2", ...
/// Unit and rate of such a table cannot be detected and stay 0.
/// Errors: the file cannot be read; unknown format.
Result<TraceSource> guess_trace_source(const std::filesystem::path& path);

}  // namespace myo::measurement
