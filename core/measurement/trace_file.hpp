#pragma once

#include <filesystem>
#include <optional>

#include "base/result.hpp"
#include "measurement/column_files.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// Forms in which motion-capture recordings come.
enum class TraceFormat { csv, qtm_tsv, c3d, columns };

/// The schema's word for a format.
const char* to_string(TraceFormat format);

/// How a file is to be read.
struct TraceSource {
    TraceFormat format = TraceFormat::csv;
    std::optional<ColumnLayout> columns;    // for `columns`
    std::optional<double> metres_per_unit;  // of a C3D file that names no unit
};

/// Errors: those of the format's reader.
Result<Recording> read_trace(const std::filesystem::path& path, const TraceSource& source);

/// The format of a file, from its ending and its first lines, and of a table without header its separator and how many
/// markers fit; these are named "marker 1", "marker 2", ... Unit and rate of such a table are not in it: they are left
/// 0. Errors: the file cannot be read; it is of no known form.
Result<TraceSource> guess_trace_source(const std::filesystem::path& path);

}  // namespace myo::measurement
