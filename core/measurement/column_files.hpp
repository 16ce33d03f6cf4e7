#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// Layout of a table without header: x, y, z of each marker in turn.
struct ColumnLayout {
    std::vector<std::string> labels;  // one per marker, in column order
    double metres_per_unit = 0.0;     // required
    char separator = ',';
    double rate_Hz = 0.0;           // required; sample k is at time k / rate_Hz
    bool zero_is_occluded = false;  // for streams that write 0, 0, 0 in gaps
};

/// Reads a table without header.
///
/// Errors (file, line, column): missing fields; fields that are not numbers; no rows; a layout without unit, rate or
/// labels.
Result<Recording> read_columns(const std::filesystem::path& path, const ColumnLayout& layout);

/// Header names of the coordinate columns of a marker.
struct MappedMarker {
    std::string label;
    std::array<std::string, 3> columns;  // x, y, z
};

/// How to read a table of unknown origin by the names in its header line.
struct HeaderMapping {
    std::vector<MappedMarker> markers;
    std::optional<std::string> time_column;  // absent: times follow from rate_Hz
    double seconds_per_unit = 1.0;           // unit of the time column
    double rate_Hz = 0.0;                    // required without a time column
    double metres_per_unit = 0.0;            // required
    char separator = ',';
    bool decimal_comma = false;     // 1,5 means 1.5; the separator must then be another character
    int header_line = 1;            // number of the header line, from 1; lines before it are ignored
    bool zero_is_occluded = false;  // for streams that write 0, 0, 0 in gaps
};

/// Reads a table with a header line.
///
/// Errors: those of read_columns(); a column that is missing from the header or appears twice (the closest name is
/// suggested); descending times.
Result<Recording> read_mapped_csv(const std::filesystem::path& path, const HeaderMapping& mapping);

}  // namespace myo::measurement
