#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "measurement/trace_reader.hpp"

namespace myo::measurement {

/// Reads a tab-separated export of Qualisys Track Manager. The file is in millimetres.
///
/// Header lines may have any order; unknown ones are ignored. After a line that starts with `Frame` the first two
/// columns are frame number and time; otherwise all columns are coordinates and frame k is at (k - 1) / FREQUENCY. A
/// marker is occluded at exactly 0.000 0.000 0.000, or if a field is empty or NULL.
/// Example, fields separated by tabs:
///   NO_OF_MARKERS 2
///   FREQUENCY 100
///   MARKER_NAMES base tip
///   Frame Time base X base Y base Z tip X tip Y tip Z
/// followed by one row per frame.
/// Errors (file, line, column): MARKER_NAMES or FREQUENCY missing; header counts that differ from the content; rows of
/// unequal length; fields that are not numbers; times that do not ascend.
Result<Recording> read_qtm_tsv(const std::filesystem::path& path, const TraceSource& source = {});

}  // namespace myo::measurement
