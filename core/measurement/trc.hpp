#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "measurement/trace_reader.hpp"

namespace myo::measurement {

/// Reads a TRC file (Motion Analysis, OpenSim): tab-separated, with its rate and unit in the header.
///
/// Line 1 begins with PathFileType. Line 2 holds keys and line 3 their values; DataRate and Units are used, NumFrames
/// and NumMarkers are checked. Line 4 is `Frame#`, `Time` and the name of each marker, at the first of its three
/// columns, or one after the other; line 5 names the axes and may be missing. A sample with an empty coordinate is
/// occluded; cells may be missing at the end of a row. Example:
///   PathFileType 4 (X/Y/Z) beam.trc
///   DataRate NumFrames NumMarkers Units
///   100.00 2 1 mm
///   Frame# Time tip
///   X1 Y1 Z1
///   1 0.00 119.9 0.1 14.1
/// Errors (file, line, column): a header line or key that is missing; an unknown unit and none in `source`, or another
/// one; counts that differ from the content; rows that are too long; fields that are not numbers; times that do not
/// ascend, or against DataRate, see set_rate().
/// Source: OpenSim documentation, "Marker (.trc) files".
Result<Recording> read_trc(const std::filesystem::path& path, const TraceSource& source = {});

}  // namespace myo::measurement
