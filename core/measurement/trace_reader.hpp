#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "measurement/column_files.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// How to read a file: its format, and what the file does not say itself.
struct TraceSource {
    std::string format;                     // id of a reader
    std::optional<ColumnLayout> columns{};  // required for the format `columns`
    /// Unit of length for a file that names none or an unknown one. A file that names another unit is refused.
    std::optional<double> metres_per_unit{};
    std::optional<double> seconds_per_unit{};  // unit of the time column; empty: seconds
};

/// A file format of motion-capture recordings.
struct TraceReader {
    std::string id;                      // value of trial.format
    std::string label;                   // for display
    std::vector<std::string> endings{};  // of its files, with the dot
    std::string signature;               // how its files begin, for the message about an unknown file
    /// The recording was not made for one experiment: its frame is the cameras', and its start has to be sought.
    bool of_cameras = false;
    /// It may hold markers that the experiment does not declare; they are ignored with a warning.
    bool with_other_markers = false;
    /// A file may state no unit; TraceSource::metres_per_unit then does.
    bool may_lack_unit = false;
    bool has_times = false;  // its files have a column of times
    bool is_y_up = false;    // the y axis of its programs points up, unless the export was set otherwise
    /// How to read a file with this content; empty if it has another format.
    std::optional<TraceSource> (*recognise)(std::string_view content);
    Result<Recording> (*read)(const std::filesystem::path& path, const TraceSource& source);
};

/// The first line of a text that is not blank; empty if there is none.
std::string_view first_line(std::string_view content);

}  // namespace myo::measurement
