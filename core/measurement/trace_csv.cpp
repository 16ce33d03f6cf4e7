#include "measurement/trace_csv.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "base/files.hpp"
#include "measurement/sample_table.hpp"
#include "measurement/text_table.hpp"
#include "measurement/units.hpp"

namespace myo::measurement {
namespace {

struct TraceCsvPolicy {
    std::size_t quoted = 40;  // characters of a wrong field in messages
};
constexpr TraceCsvPolicy trace_csv_policy;

constexpr std::array<std::string_view, 3> axis_suffixes{"_x_m", "_y_m", "_z_m"};

/// A column of coordinates by its name: "tip_x_m".
struct CoordinateColumn {
    std::string_view marker;
    std::size_t axis = 0;  // 0, 1, 2
    std::string_view unit;
};

/// Empty if the name has another form.
std::optional<CoordinateColumn> coordinate_column(std::string_view name) {
    const std::size_t unit = name.rfind('_');
    if (unit == std::string_view::npos || unit < 3 || name[unit - 2] != '_') return std::nullopt;
    const std::size_t axis = std::string_view("xyz").find(name[unit - 1]);
    const CoordinateColumn column{name.substr(0, unit - 2), axis, name.substr(unit + 1)};
    const bool known = std::any_of(length_units.begin(), length_units.end(),
                                   [&](const auto& entry) { return column.unit == entry.first; });
    return known && axis < 3 ? std::optional(column) : std::nullopt;
}

Result<void> check_complete(const std::vector<MarkerColumns>& markers, std::size_t absent, const std::string& unit,
                            const std::string& where) {
    for (const MarkerColumns& marker : markers) {
        for (std::size_t a = 0; a < 3; ++a) {
            if (marker.columns[a] == absent) {
                return Error{"column '" + marker.label + "_" + "xyz"[a] + "_" + unit + "' is missing", where};
            }
        }
    }
    return {};
}

// Columns of the axes of each marker, from the header line.
Result<std::vector<MarkerColumns>> marker_columns(const std::vector<std::string_view>& names, const std::string& unit,
                                                  const std::string& where) {
    std::vector<MarkerColumns> markers;
    std::map<std::string, std::size_t, std::less<>> index;
    constexpr std::size_t absent = static_cast<std::size_t>(-1);
    for (std::size_t column = 1; column < names.size(); ++column) {
        const std::string_view name = names[column];
        const std::optional<CoordinateColumn> coordinate = coordinate_column(name);
        // One unit for all columns; that of most is told apart by the last one.
        if (!coordinate || coordinate->unit != unit) {
            return Error{"column " + std::to_string(column + 1) + " is '" + std::string(name) +
                             "', expected <marker>_x_" + unit + ", <marker>_y_" + unit + " or <marker>_z_" + unit,
                         where};
        }
        const std::string label(coordinate->marker);
        // Columns of a marker need not be adjacent.
        const auto [entry, is_new] = index.emplace(label, markers.size());
        if (is_new) markers.push_back({label, {absent, absent, absent}});
        std::size_t& place = markers[entry->second].columns[coordinate->axis];
        if (place != absent) return Error{"column '" + std::string(name) + "' appears twice", where};
        place = column;
    }
    if (const Result<void> complete = check_complete(markers, absent, unit, where); !complete) return complete.error();
    if (markers.empty()) return Error{"names no marker", where};
    return markers;
}

/// Column name, quoted if the label contains the separator, or begins with blanks, which a reader would drop.
std::string header_name(const std::string& label, std::string_view suffix) {
    const std::string name = label + std::string(suffix);
    return name.find(',') == std::string::npos && trimmed(name) == name ? name : "\"" + name + "\"";
}

/// Separator of a header: the character behind the first column, if it is one of those in use.
char separator_of(std::string_view header) {
    const std::size_t end = header.find_first_of(",;\t");
    return end == std::string_view::npos ? ',' : header[end];
}

/// Unit of the last column; m if it has none.
std::string unit_of(const std::vector<std::string_view>& names) {
    const std::optional<CoordinateColumn> last = coordinate_column(names.back());
    return last ? std::string(last->unit) : "m";
}

}  // namespace

Result<Recording> read_trace_csv(const std::filesystem::path& path, const TraceSource& source) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    const std::vector<TextLine> lines = split_lines(*content);
    const std::string where = at_line(path, 1);
    if (lines.empty()) return Error{"is empty, expected a header 'time_s,...'", where};
    SampleTable table;
    table.separator = separator_of(lines[0].text);
    // Only another separator leaves the comma to the numbers.
    table.decimal_comma = table.separator != ',';
    const std::vector<std::string_view> names = split_fields(lines[0].text, table.separator);
    if (names[0] != "time_s")
        return Error{
            "the first column is '" + std::string(names[0].substr(0, trace_csv_policy.quoted)) + "', expected 'time_s'",
            where};
    const std::string unit = unit_of(names);
    const Result<double> metres = recording_unit("the header", unit, source.metres_per_unit, where);
    if (!metres) return metres.error();
    Result<std::vector<MarkerColumns>> markers = marker_columns(names, unit, where);
    if (!markers) return markers.error();
    table.markers = std::move(*markers);
    table.metres_per_unit = *metres;
    table.time_column = 0;
    table.seconds_per_unit = source.seconds_per_unit.value_or(1.0);
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
            .has_times = true,
            .recognise = [](std::string_view content) -> std::optional<TraceSource> {
                if (!trimmed(first_line(content)).starts_with("time_s")) return std::nullopt;
                return TraceSource{.format = "csv"};
            },
            .read = [](const std::filesystem::path& path,
                       const TraceSource& source) { return read_trace_csv(path, source); }};
}

}  // namespace myo::measurement
