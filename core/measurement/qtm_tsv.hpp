#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// Reads a tab-separated export of Qualisys Track Manager; the file is in millimetres.
///
/// Header lines stand in any order, unknown ones are ignored. With a line starting with `Frame` the first two columns
/// are frame and time; without it all columns are coordinates and frame k is at (k - 1) / FREQUENCY. A marker at
/// exactly 0.000 0.000 0.000, or with an empty or NULL field, is occluded. Errors, with file, line and column:
/// MARKER_NAMES or FREQUENCY missing, counts of the header that the content does not have, ragged rows, fields that are
/// no numbers, times that do not ascend.
Result<Recording> read_qtm_tsv(const std::filesystem::path& path);

}  // namespace myo::measurement
