#pragma once

#include <filesystem>
#include <optional>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

// A C3D file consists of blocks of 512 bytes: one header block, the parameter section, and the data. Counts, rate,
// scale and unit are stored in the parameters, some of them also in the header. Data are frames of 3D points (four
// words each) followed by the analog samples of the frame. Writers deviate from the format in many ways; the rules
// below accept the known deviations and refuse what would give wrong coordinates.

/// Reads the 3D points of a C3D file: integer and float data, in Intel, DEC and SGI number formats.
///
/// Analog channels, events and force plates are skipped, and so are outputs of a model among the points (POINT:ANGLES,
/// FORCES, ... and what TYPE_GROUPS names). A frame count in POINT:FRAMES above that of header and file gives a
/// warning.
/// @param metres_per_unit  required if the file states no unit or an unknown one, because units are never guessed
/// @return  first sample at time 0; labels trimmed, "point k" for a missing one, "label (2)" for a repeated one.
///          A sample is occluded (NaN) if its fourth word is negative or not a number, or if its coordinates and its
///          fourth word are all exactly 0: several programs write gaps in this way.
/// Errors: not a C3D file; damaged or truncated (with parameter name or byte offset); no points; no rate; no unit.
/// Source: the C3D file format, www.c3d.org; frame counts above 65535 as in its "The C3D frame count".
Result<Recording> read_c3d(const std::filesystem::path& path, std::optional<double> metres_per_unit = std::nullopt);

}  // namespace myo::measurement
