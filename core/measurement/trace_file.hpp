#pragma once

#include <filesystem>
#include <optional>

#include "base/result.hpp"
#include "measurement/column_files.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// File formats of motion-capture recordings.
enum class TraceFormat { csv, qtm_tsv, c3d, columns };

/// Name of a format in the experiment schema.
const char* to_string(TraceFormat format);

/// How to read a file.
struct TraceSource {
    TraceFormat format = TraceFormat::csv;
    std::optional<ColumnLayout> columns;    // required for the format `columns`
    std::optional<double> metres_per_unit;  // for a C3D file that states no unit
};

/// Reads a recording with the reader of its format.
/// Errors: those of the reader.
Result<Recording> read_trace(const std::filesystem::path& path, const TraceSource& source);

/// Detects the format of a file from its first bytes and lines.
///
/// For a table without header also the separator and the number of markers, which are named "marker 1", "marker 2", ...
/// Unit and rate of such a table cannot be detected and stay 0.
/// Errors: the file cannot be read; unknown format.
Result<TraceSource> guess_trace_source(const std::filesystem::path& path);

}  // namespace myo::measurement
