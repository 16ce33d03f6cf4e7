#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "measurement/trace_reader.hpp"

namespace myo::measurement {

/// Reads a trace in the csv format of an experiment folder:
/// `time_s,<marker>_x_m,<marker>_y_m,<marker>_z_m,...`, in metres; `_dm`, `_cm`, `_mm` or `_um` in all columns states
/// another unit.
///
/// Columns may be separated by `;` or tabs instead; numbers may then have a decimal comma.
/// A sample is occluded by `nan` or an empty field. Markers keep the order of their first column; rate_Hz is the
/// inverse of the median time step. Rows that repeat their predecessor (polled streams) are kept: see
/// repeated_samples().
/// Errors (file and line): a field that is not a number; a missing axis; a duplicate or unknown
/// column; times that do not ascend; rows of unequal length; no rows; a unit in `source` that the header contradicts.
Result<Recording> read_trace_csv(const std::filesystem::path& path, const TraceSource& source = {});

/// Writes the format of read_trace_csv(), `nan` in gaps. Numbers read back exactly.
///
/// Errors: the file cannot be written; a label that a csv header cannot hold.
Result<void> write_trace_csv(const std::filesystem::path& path, const Recording& recording);

}  // namespace myo::measurement
