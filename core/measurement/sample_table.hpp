#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/recording.hpp"
#include "measurement/text_table.hpp"

namespace myo::measurement {

/// Column indices, from 0, of the x, y and z of a marker.
struct MarkerColumns {
    std::string label;
    std::array<std::size_t, 3> columns{};
};

/// How to read the rows of a text table as samples.
struct SampleTable {
    std::vector<MarkerColumns> markers;
    std::optional<std::size_t> time_column;   // absent: sample k is at time k / rate_Hz
    std::optional<std::size_t> frame_column;  // only checked to be a number
    double seconds_per_unit = 1.0;            // unit of the time column
    double rate_Hz = 0.0;                     // 0 with a time column: the inverse of the median time step
    double metres_per_unit = 1.0;
    std::size_t field_count = 0;  // expected number of fields per row
    char separator = ',';
    bool decimal_comma = false;
    bool zero_is_occluded = false;    // a marker at exactly 0, 0, 0 is occluded
    bool null_is_occluded = false;    // the word NULL means occluded
    bool trailing_separator = false;  // allow one empty field at the end of a row
    bool ragged = false;  // cells missing at the end of a row are gaps, empty ones beyond the last are ignored
    std::vector<std::string> column_names;  // for messages; may be empty
};

/// Reads rows into a recording. A sample with any coordinate missing is occluded as a whole.
///
/// Errors (file, line, column): no rows; rows of unequal length; a field that is not a number; times that do not
/// ascend.
Result<Recording> read_samples(const std::filesystem::path& path, std::span<const TextLine> rows,
                               const SampleTable& table);

/// Sets the rate of a recording to the rate that the file states, or to that of its times if the two differ; the latter
/// adds a warning.
///
/// @param field  name of the stated rate, for messages: "DataRate"
/// @param where  its place
/// @param time_unit_is_declared  the unit of the times is not in question
/// Errors: times in a unit other than seconds, by their ratio to the stated rate; the message names unit and key.
Result<void> set_rate(Recording& recording, const std::string& field, double stated_Hz, const std::string& where,
                      bool time_unit_is_declared);

/// Inverse of the median time step [Hz], rounded to nine digits; 100 for fewer than two samples.
double median_rate(const Eigen::VectorXd& time_s);

}  // namespace myo::measurement
