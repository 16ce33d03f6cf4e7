#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// A table without a header: x y z of each marker in turn.
struct ColumnLayout {
    std::vector<std::string> labels;
    double metres_per_unit = 0.0;  // required
    char separator = ',';
    double rate_Hz = 0.0;           // required; sample k is at k / rate_Hz
    bool zero_is_occluded = false;  // for streams that write 0, 0, 0 into gaps
};

/// Errors, with file, line and column: fields missing or not numbers, no rows; a layout without unit, rate or labels.
Result<Recording> read_columns(const std::filesystem::path& path, const ColumnLayout& layout);

/// Which columns of a table with a header line are the coordinates of a marker.
struct MappedMarker {
    std::string label;
    std::array<std::string, 3> columns;
};

/// A table of other origin, told by the names in its header line.
struct HeaderMapping {
    std::vector<MappedMarker> markers;
    std::optional<std::string> time_column;
    double seconds_per_unit = 1.0;  // of the time column
    double rate_Hz = 0.0;           // required without a time column
    double metres_per_unit = 0.0;   // required
    char separator = ',';
    bool decimal_comma = false;  // 1,5 for 1.5; then the separator must be another character
    int header_line = 1;         // lines before it are ignored
    bool zero_is_occluded = false;
};

/// Errors as for read_columns; a column that is not in the header, or twice (the nearest name is offered); descending
/// times.
Result<Recording> read_mapped_csv(const std::filesystem::path& path, const HeaderMapping& mapping);

}  // namespace myo::measurement
