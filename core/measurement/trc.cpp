#include "measurement/trc.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "base/files.hpp"
#include "base/text.hpp"
#include "measurement/sample_table.hpp"
#include "measurement/trace_reader.hpp"
#include "measurement/units.hpp"

namespace myo::measurement {
namespace {

constexpr std::string_view signature = "PathFileType";

/// Lines of the header, from 0.
enum HeaderLine : std::size_t { keys_line = 1, values_line = 2, names_line = 3, axes_line = 4, least_lines = 5 };

/// Values of line 3 by the keys of line 2.
std::map<std::string, std::string> header_values(const std::vector<TextLine>& lines) {
    const std::vector<std::string_view> keys = split_fields(lines[keys_line].text, '\t'),
                                        values = split_fields(lines[values_line].text, '\t');
    std::map<std::string, std::string> table;
    for (std::size_t i = 0; i < std::min(keys.size(), values.size()); ++i)
        table.emplace(std::string(keys[i]), std::string(values[i]));
    return table;
}

/// A number of the header.
Result<double> header_number(const std::map<std::string, std::string>& values, const std::string& key,
                             const std::filesystem::path& path) {
    const auto found = values.find(key);
    double number = 0.0;
    if (found == values.end()) return Error{"has no " + key + " in its header", at_line(path, keys_line + 1)};
    if (!parse_number(found->second, number) || !(number > 0.0))
        return Error{key + " is '" + found->second + "', expected a number above 0", at_line(path, values_line + 1)};
    return number;
}

/// Whether the fields from the third on are names, one after the other without the empty fields of y and z.
bool is_list_of_names(const std::vector<std::string_view>& fields) {
    return fields.size() > 3 &&
           std::none_of(fields.begin() + 2, fields.end(), [](std::string_view field) { return field.empty(); });
}

/// Names of the markers, each at the first of its columns, or one after the other.
Result<std::vector<std::string>> marker_names(const TextLine& line, const std::filesystem::path& path) {
    std::vector<std::string_view> fields = split_fields(line.text, '\t');
    if (fields.size() < 2 || fields[0] != "Frame#" || fields[1] != "Time")
        return Error{"the columns do not begin with Frame# and Time", at_line(path, line.number)};
    while (fields.back().empty()) fields.pop_back();
    const std::size_t columns = is_list_of_names(fields) ? 1 : 3;
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (std::size_t i = 2; i < fields.size(); ++i) {
        if (fields[i].empty()) continue;
        if (i != 2 + columns * names.size())
            return Error{"the name '" + std::string(fields[i]) + "' stands in column " + std::to_string(i + 1) +
                             ", expected in column " + std::to_string(3 + columns * names.size()) +
                             ": each marker has three columns",
                         at_line(path, line.number)};
        names.emplace_back(fields[i]);
        if (!taken.insert(names.back()).second)
            return Error{"names '" + names.back() + "' twice", at_line(path, line.number)};
    }
    if (names.empty()) return Error{"names no marker", at_line(path, line.number)};
    return names;
}

/// Checks a count of the header against the content.
Result<void> check_count(const std::map<std::string, std::string>& values, const std::string& key, std::size_t found,
                         const std::filesystem::path& path) {
    const Result<double> declared = header_number(values, key, path);
    if (!declared) return declared.error();
    if (*declared != static_cast<double>(found))
        return Error{key + " is " + format_number(*declared, 12) + ", but the file has " + std::to_string(found),
                     at_line(path, values_line + 1)};
    return {};
}

/// Metres per unit of length.
Result<double> header_unit(const std::map<std::string, std::string>& values, std::optional<double> declared,
                           const std::filesystem::path& path) {
    const auto unit = values.find("Units");
    return recording_unit("Units", unit == values.end() ? "" : unit->second, declared, at_line(path, values_line + 1));
}

/// Columns of the rows: frame, time, and three coordinates of each marker.
SampleTable trc_table(const std::vector<std::string>& names, double metres_per_unit, double seconds_per_unit) {
    SampleTable table;
    table.separator = '\t';
    table.metres_per_unit = metres_per_unit;
    table.seconds_per_unit = seconds_per_unit;
    table.ragged = true;
    table.frame_column = 0;
    table.time_column = 1;
    table.column_names = {"Frame#", "Time"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        table.markers.push_back({names[i], {2 + 3 * i, 3 + 3 * i, 4 + 3 * i}});
        for (const char* axis : {" X", " Y", " Z"}) table.column_names.push_back(names[i] + axis);
    }
    table.field_count = 2 + 3 * names.size();
    return table;
}

}  // namespace

Result<Recording> read_trc(const std::filesystem::path& path, const TraceSource& source) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    const std::vector<TextLine> lines = split_lines(*content);
    if (lines.size() < least_lines || !lines[0].text.starts_with(signature))
        return Error{"is no TRC file: its five header lines begin with PathFileType", at_line(path, 1)};
    const std::map<std::string, std::string> values = header_values(lines);
    const Result<double> rate = header_number(values, "DataRate", path);
    if (!rate) return rate.error();
    const Result<double> metres = header_unit(values, source.metres_per_unit, path);
    if (!metres) return metres.error();
    const Result<std::vector<std::string>> names = marker_names(lines[names_line], path);
    if (!names) return names.error();

    // Some exports have no line of axes, most have a blank line between header and rows.
    double frame = 0.0;
    const bool has_axes = !parse_number(split_fields(lines[axes_line].text, '\t')[0], frame);
    std::size_t first = has_axes ? axes_line + 1 : std::size_t{axes_line};
    while (first < lines.size() && trimmed(lines[first].text).empty()) ++first;
    const std::span<const TextLine> rows = std::span<const TextLine>(lines).subspan(first);
    if (const Result<void> counted = check_count(values, "NumMarkers", names->size(), path); !counted)
        return counted.error();
    if (const Result<void> counted = check_count(values, "NumFrames", rows.size(), path); !counted)
        return counted.error();

    Result<Recording> recording = read_samples(path, rows,
                                               trc_table(*names, *metres, source.seconds_per_unit.value_or(1.0)));
    if (!recording) return recording;
    if (const Result<void> rated = set_rate(*recording, "DataRate", *rate, at_line(path, values_line + 1),
                                            source.seconds_per_unit.has_value());
        !rated)
        return rated.error();
    return recording;
}

TraceReader trc_reader() {
    return {
        .id = "trc",
        .label = "TRC",
        .endings = {".trc"},
        .signature = "begins with PathFileType",
        .of_cameras = true,
        .with_other_markers = true,
        .may_lack_unit = true,
        .has_times = true,
        .recognise = [](std::string_view content) -> std::optional<TraceSource> {
            if (!first_line(content).starts_with(signature)) return std::nullopt;
            return TraceSource{.format = "trc"};
        },
        .read = [](const std::filesystem::path& path, const TraceSource& source) { return read_trc(path, source); }};
}

}  // namespace myo::measurement
