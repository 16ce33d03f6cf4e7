#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// Reads a TRC file (Motion Analysis, OpenSim): tab-separated, with its rate and unit in the header.
///
/// Line 1 begins with PathFileType. Line 2 holds keys and line 3 their values; DataRate and Units are used, NumFrames
/// and NumMarkers are checked. Line 4 is `Frame#`, `Time` and the name of each marker, at the first of its three
/// columns; line 5 names the axes. A sample with an empty coordinate is occluded. Example:
///   PathFileType 4 (X/Y/Z) beam.trc
///   DataRate NumFrames NumMarkers Units
///   100.00 2 1 mm
///   Frame# Time tip
///   X1 Y1 Z1
///   1 0.00 119.9 0.1 14.1
/// Errors (file, line, column): a header line or key that is missing; an unknown unit; counts that differ from the
/// content; rows of unequal length; fields that are not numbers; times that do not ascend.
/// Source: OpenSim documentation, "Marker (.trc) files".
Result<Recording> read_trc(const std::filesystem::path& path);

}  // namespace myo::measurement
