#pragma once

#include <filesystem>
#include <optional>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// Reads the 3D points of a C3D file: integer and float data, words of Intel, DEC and SGI machines.
///
/// @param metres_per_unit  overrides POINT:UNITS; needed when the file names no unit, for units are never guessed
/// @return  first sample at time 0; labels trimmed, "point k" where there is none, "label (2)" for a repeated one.
///          A sample is occluded (NaN) when its fourth word is negative or no number, or when all three coordinates are
///          exactly 0 and the fourth word is too: that is how several programs write a gap, and no camera took part.
/// Errors: not a C3D file, damaged or truncated (names the parameter or the byte offset), no points, no rate, no unit.
/// Analog channels, events and force plates are skipped.
/// Source: the C3D file format, www.c3d.org; frame counts above 65535 as its "The C3D frame count" lists them.
Result<Recording> read_c3d(const std::filesystem::path& path, std::optional<double> metres_per_unit = std::nullopt);

}  // namespace myo::measurement
