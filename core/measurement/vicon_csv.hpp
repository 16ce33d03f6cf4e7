#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "measurement/trace_reader.hpp"

namespace myo::measurement {

/// Reads the section `Trajectories` of a CSV export of Vicon Nexus; other sections are skipped.
///
/// The section is its title, the rate [Hz], a row with the name of each marker ("subject:name") at the first of its
/// columns, the row `Frame, Sub Frame, X, Y, Z, ...`, a row with the units, and one row per frame up to a blank line.
/// Velocities (X', X'') that were exported beside the coordinates are skipped. The first frame is at 0 s. Empty cells,
/// also missing ones at the end of a row, are gaps. The separator is the character behind `Frame`; with any other than
/// a comma, numbers may have a decimal comma.
/// Errors (file, line, column): no such section; a row missing; a marker without one of its axes; units that differ,
/// unknown ones and none in `source`, or another one; frames that do not ascend; fields that are not numbers.
/// Source: Vicon Nexus documentation, "ASCII file format".
Result<Recording> read_vicon_csv(const std::filesystem::path& path, const TraceSource& source = {});

}  // namespace myo::measurement
