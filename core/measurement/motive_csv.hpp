#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "measurement/trace_reader.hpp"

namespace myo::measurement {

/// Reads a CSV export of OptiTrack Motive (format version 1.2 and later), with rate and unit of its first line.
///
/// The first line holds keys and values in turn; `Export Frame Rate` (otherwise `Capture Frame Rate`) and `Length
/// Units` are used. Rows `Type`, `Name` and others follow, then one that says `Position` or `Rotation`, then the row
/// `Frame, Time (Seconds), X, Y, Z, ...`. Columns of type `Marker` with a position are markers. Rigid bodies, bones,
/// markers that belong to them, and columns of errors and quality are skipped; if no column has the type `Marker`, the
/// markers of rigid bodies are read. Empty cells, also missing ones at the end of a row, are gaps.
/// Errors (file, line, column): a missing row or key; a marker without one of its axes; an unknown unit and none in
/// `source`, or another one; times against the stated rate, see set_rate(); fields that are not numbers.
/// Source: OptiTrack documentation, "Data Export: CSV".
Result<Recording> read_motive_csv(const std::filesystem::path& path, const TraceSource& source = {});

}  // namespace myo::measurement
