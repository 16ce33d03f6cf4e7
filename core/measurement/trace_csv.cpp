#include "measurement/trace_csv.hpp"

#include <array>
#include <map>
#include <optional>

#include "base/files.hpp"
#include "measurement/sample_table.hpp"
#include "measurement/text_table.hpp"
#include "measurement/trace_reader.hpp"

namespace myo::measurement {
namespace {

constexpr std::array<std::string_view, 3> axis_suffixes{"_x_m", "_y_m", "_z_m"};

/// The coordinate that a column name ends with.
std::optional<std::size_t> axis_of(std::string_view name) {
    std::optional<std::size_t> axis;
    for (std::size_t a = 0; a < 3; ++a) {
        if (name.size() > axis_suffixes[a].size() && name.ends_with(axis_suffixes[a])) axis = a;
    }
    return axis;
}

Result<void> check_complete(const std::vector<MarkerColumns>& markers, std::size_t absent, const std::string& where) {
    for (const MarkerColumns& marker : markers) {
        for (std::size_t a = 0; a < 3; ++a) {
            if (marker.columns[a] == absent) {
                return Error{"column '" + marker.label + std::string(axis_suffixes[a]) + "' is missing", where};
            }
        }
    }
    return {};
}

// Columns of the axes of each marker, from the header line.
Result<std::vector<MarkerColumns>> marker_columns(const std::vector<std::string_view>& names,
                                                  const std::string& where) {
    std::vector<MarkerColumns> markers;
    std::map<std::string, std::size_t, std::less<>> index;
    constexpr std::size_t absent = static_cast<std::size_t>(-1);
    for (std::size_t column = 1; column < names.size(); ++column) {
        const std::string_view name = names[column];
        const std::optional<std::size_t> axis = axis_of(name);
        if (!axis) {
            return Error{"column " + std::to_string(column + 1) + " is '" + std::string(name) +
                             "', expected <marker>_x_m, <marker>_y_m or <marker>_z_m",
                         where};
        }
        const std::string label(name.substr(0, name.size() - 4));
        // Columns of a marker need not be adjacent.
        const auto [entry, is_new] = index.emplace(label, markers.size());
        if (is_new) markers.push_back({label, {absent, absent, absent}});
        std::size_t& place = markers[entry->second].columns[*axis];
        if (place != absent) return Error{"column '" + std::string(name) + "' appears twice", where};
        place = column;
    }
    if (const Result<void> complete = check_complete(markers, absent, where); !complete) return complete.error();
    if (markers.empty()) return Error{"names no marker", where};
    return markers;
}

/// Column name, quoted if the label contains the separator.
std::string header_name(const std::string& label, std::string_view suffix) {
    const std::string name = label + std::string(suffix);
    return name.find(',') == std::string::npos ? name : "\"" + name + "\"";
}

}  // namespace

Result<Recording> read_trace_csv(const std::filesystem::path& path) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    const std::vector<TextLine> lines = split_lines(*content);
    if (lines.empty()) return Error{"is empty, expected a header 'time_s,...'", at_line(path, 1)};
    const std::vector<std::string_view> names = split_fields(lines[0].text, ',');
    if (names[0] != "time_s") {
        return Error{"the first column is '" + std::string(names[0]) + "', expected 'time_s'", at_line(path, 1)};
    }
    Result<std::vector<MarkerColumns>> markers = marker_columns(names, at_line(path, 1));
    if (!markers) return markers.error();
    SampleTable table;
    table.markers = std::move(*markers);
    table.time_column = 0;
    table.field_count = names.size();
    for (const std::string_view name : names) table.column_names.emplace_back(name);
    return read_samples(path, std::span(lines).subspan(1), table);
}

Result<void> write_trace_csv(const std::filesystem::path& path, const Recording& recording) {
    std::string text = "time_s";
    for (const std::string& label : recording.labels) {
        // Quotes and line ends would not survive reading the header back.
        if (label.empty() || label.find_first_of("\"\n\r") != std::string::npos) {
            return Error{"marker label '" + label + "' cannot stand in a csv header", path.string()};
        }
        for (const std::string_view suffix : axis_suffixes) text.append(",").append(header_name(label, suffix));
    }
    text += '\n';
    for (Eigen::Index t = 0; t < recording.sample_count(); ++t) {
        text += exact_number(recording.time_s(t));
        for (const Eigen::Matrix3Xd& track : recording.tracks) {
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                text += ',';
                text += exact_number(track(axis, t));
            }
        }
        text += '\n';
    }
    return write_file(path, text);
}

TraceReader trace_csv_reader() {
    return {.id = "csv",
            .label = "CSV",
            .endings = {".csv"},
            .signature = "begins with time_s",
            .recognise = [](std::string_view content) -> std::optional<TraceSource> {
                if (!trimmed(first_line(content)).starts_with("time_s")) return std::nullopt;
                return TraceSource{.format = "csv"};
            },
            .read = [](const std::filesystem::path& path, const TraceSource&) { return read_trace_csv(path); }};
}

}  // namespace myo::measurement
