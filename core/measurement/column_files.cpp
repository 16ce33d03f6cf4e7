#include "measurement/column_files.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/files.hpp"
#include "base/text.hpp"
#include "measurement/sample_table.hpp"
#include "measurement/trace_reader.hpp"

namespace myo::measurement {
namespace {

constexpr std::string_view separators = ",;\t ";

/// Whether a field is a number, with a comma or point, or a mark for a missing value.
bool is_value(std::string_view field) {
    double value;
    std::string with_point(field);
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    return field == "NULL" || parse_sample(with_point, value);
}

/// Source of a table without header: the separator that splits the line into whole markers.
std::optional<TraceSource> headerless(std::string_view line) {
    for (const char separator : separators) {
        const std::vector<std::string_view> fields = split_fields(line, separator);
        if (fields.size() < 3 || fields.size() % 3 != 0 || !std::all_of(fields.begin(), fields.end(), is_value))
            continue;
        TraceSource source{.format = "columns", .columns = ColumnLayout{}};
        source.columns->separator = separator;
        for (std::size_t m = 0; m < fields.size() / 3; ++m)
            source.columns->labels.push_back("marker " + std::to_string(m + 1));
        return source;
    }
    return std::nullopt;
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

/// Index of a header name.
/// Errors: missing (with the closest name) or duplicate.
Result<std::size_t> column_index(const std::vector<std::string>& names, const std::string& name,
                                 const std::string& where) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
        const std::string near = closest_word(name, names);
        return Error{
            "column '" + name + "' is not in the header" + (near.empty() ? "" : "; the closest name is '" + near + "'"),
            where};
    }
    if (std::find(found + 1, names.end(), name) != names.end())
        return Error{"column '" + name + "' appears twice", where};
    return static_cast<std::size_t>(found - names.begin());
}

/// Whether the mapping is complete and unambiguous.
Result<void> check_mapping(const HeaderMapping& mapping, const std::filesystem::path& path) {
    if (mapping.markers.empty()) return Error{"the header mapping names no marker", path.string()};
    if (!positive(mapping.metres_per_unit)) return Error{"the header mapping gives no length unit", path.string()};
    if (!mapping.time_column && !positive(mapping.rate_Hz)) {
        return Error{"the header mapping gives neither a time column nor a rate", path.string()};
    }
    if (mapping.time_column && !positive(mapping.seconds_per_unit))
        return Error{"the header mapping gives no unit of time", path.string()};
    // 1,5 would be ambiguous.
    if (mapping.decimal_comma && mapping.separator == ',') {
        return Error{"a comma cannot be both decimal mark and separator", path.string()};
    }
    return {};
}

/// Finds the columns of the time and of the markers by their names.
Result<void> map_columns(SampleTable& table, const HeaderMapping& mapping, const std::string& where) {
    if (mapping.time_column) {
        const Result<std::size_t> column = column_index(table.column_names, *mapping.time_column, where);
        if (!column) return column.error();
        table.time_column = *column;
        table.seconds_per_unit = mapping.seconds_per_unit;
    } else {
        table.rate_Hz = mapping.rate_Hz;
    }
    for (const MappedMarker& marker : mapping.markers) {
        MarkerColumns columns{marker.label, {}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Result<std::size_t> column = column_index(table.column_names, marker.columns[axis], where);
            if (!column) return column.error();
            columns.columns[axis] = *column;
        }
        table.markers.push_back(std::move(columns));
    }
    return {};
}

}  // namespace

Result<Recording> read_columns(const std::filesystem::path& path, const ColumnLayout& layout) {
    if (layout.labels.empty()) return Error{"no marker is named for the columns of this file", path.string()};
    if (!positive(layout.metres_per_unit))
        return Error{"no length unit is given for the columns of this file", path.string()};
    if (!positive(layout.rate_Hz)) return Error{"no rate is given for the rows of this file", path.string()};
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    SampleTable table;
    table.rate_Hz = layout.rate_Hz;
    table.metres_per_unit = layout.metres_per_unit;
    table.separator = layout.separator;
    table.decimal_comma = layout.separator != ',';
    table.zero_is_occluded = layout.zero_is_occluded;
    table.null_is_occluded = true;
    table.field_count = 3 * layout.labels.size();
    for (std::size_t i = 0; i < layout.labels.size(); ++i) {
        table.markers.push_back({layout.labels[i], {3 * i, 3 * i + 1, 3 * i + 2}});
        for (const char* axis : {" x", " y", " z"}) table.column_names.push_back(layout.labels[i] + axis);
    }
    return read_samples(path, split_lines(*content), table);
}

Result<Recording> read_mapped_csv(const std::filesystem::path& path, const HeaderMapping& mapping) {
    if (const Result<void> complete = check_mapping(mapping, path); !complete) return complete.error();
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    const std::vector<TextLine> lines = split_lines(*content);
    if (mapping.header_line < 1 || lines.size() < static_cast<std::size_t>(mapping.header_line)) {
        return Error{"has no header in line " + std::to_string(mapping.header_line), path.string()};
    }
    const auto header = static_cast<std::size_t>(mapping.header_line - 1);
    SampleTable table;
    for (const std::string_view name : split_fields(lines[header].text, mapping.separator))
        table.column_names.emplace_back(name);
    table.field_count = table.column_names.size();
    if (const Result<void> mapped = map_columns(table, mapping, at_line(path, mapping.header_line)); !mapped)
        return mapped.error();
    table.metres_per_unit = mapping.metres_per_unit;
    table.separator = mapping.separator;
    table.decimal_comma = mapping.decimal_comma;
    table.zero_is_occluded = mapping.zero_is_occluded;
    table.null_is_occluded = true;
    return read_samples(path, std::span(lines).subspan(header + 1), table);
}

TraceReader columns_reader() {
    return {.id = "columns",
            .label = "Table without header",
            .endings = {".csv", ".txt"},
            .signature = "x, y, z of each marker",
            .of_cameras = true,
            .recognise = [](std::string_view content) { return headerless(first_line(content)); },
            .read =
                [](const std::filesystem::path& path, const TraceSource& source) {
                    assert(source.columns);
                    return read_columns(path, *source.columns);
                }};
}

}  // namespace myo::measurement
