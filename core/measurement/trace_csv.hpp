#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// Reads a trace in the csv form of an experiment folder: `time_s,<marker>_x_m,<marker>_y_m,<marker>_z_m,...`, metres.
///
/// `nan` or an empty field occludes the sample. Markers keep the order in which the header first names them; rate_Hz is
/// the inverse of the median time step. Rows that repeat their predecessor (a polled stream) are kept: see
/// repeated_samples. Errors, with file and line: no number where one is expected, missing axis, duplicated or unknown
/// column, times that do not ascend, ragged rows, no rows.
Result<Recording> read_trace_csv(const std::filesystem::path& path);

/// Writes the same form, `nan` for gaps; numbers read back exactly.
Result<void> write_trace_csv(const std::filesystem::path& path, const Recording& recording);

}  // namespace myo::measurement
