#include "measurement/qtm_tsv.hpp"

#include <cmath>
#include <set>

#include "base/files.hpp"
#include "base/text.hpp"
#include "measurement/sample_table.hpp"
#include "measurement/units.hpp"

namespace myo::measurement {
namespace {

struct HeaderNumber {
    double value = 0.0;
    int line = 0;  // 0: not in the header
};

struct QtmHeader {
    HeaderNumber frames;
    HeaderNumber markers;
    HeaderNumber rate_Hz;
    std::vector<std::string> names;
    int names_line = 0;
    bool has_time = false;
    std::size_t first_row = 0;  // index into the lines
};

/// Whether a line belongs to the data: it starts with a number, NULL or an empty field.
bool starts_data(std::string_view first_field) {
    double number = 0.0;
    return first_field.empty() || first_field == "NULL" || parse_number(first_field, number);
}

/// Second field of a header line as a number; `whole`: it must be an integer.
Result<HeaderNumber> header_number(const std::vector<std::string_view>& fields, const std::string& key, int line,
                                   const std::filesystem::path& path, bool whole) {
    HeaderNumber number{0.0, line};
    const std::string text(fields.size() > 1 ? fields[1] : std::string_view());
    const bool valid = parse_number(text, number.value) && std::isfinite(number.value) && number.value >= 0.0 &&
                       (!whole || number.value == std::floor(number.value));
    if (!valid)
        return Error{key + " is '" + text + "', expected a " + (whole ? "count" : "number"), at_line(path, line)};
    return number;
}

/// Reads an entry of the header; unknown ones are ignored.
Result<void> read_entry(QtmHeader& header, const std::vector<std::string_view>& fields, int line,
                        const std::filesystem::path& path) {
    const std::string_view key = fields[0];
    if (key == "NO_OF_FRAMES" || key == "NO_OF_MARKERS") {
        const Result<HeaderNumber> number = header_number(fields, std::string(key), line, path, true);
        if (!number) return number.error();
        (key == "NO_OF_FRAMES" ? header.frames : header.markers) = *number;
    } else if (key == "FREQUENCY" && !(fields.size() > 1 && fields[1] == "EXT")) {  // EXT: external clock
        const Result<HeaderNumber> number = header_number(fields, "FREQUENCY", line, path, false);
        if (!number) return number.error();
        header.rate_Hz = *number;
    } else if (key == "MARKER_NAMES") {
        for (std::size_t k = 1; k < fields.size(); ++k) header.names.emplace_back(fields[k]);
        // Exports may end the line with separators.
        while (!header.names.empty() && header.names.back().empty()) header.names.pop_back();
        header.names_line = line;
    }
    return {};
}

/// Reads header lines up to the first data line, or through the line `Frame`.
Result<QtmHeader> read_header(const std::vector<TextLine>& lines, const std::filesystem::path& path) {
    QtmHeader header;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::vector<std::string_view> fields = split_fields(lines[i].text, '\t');
        const std::string_view key = fields[0];
        header.first_row = i + 1;
        if (trimmed(lines[i].text).empty()) continue;
        if (starts_data(key)) {
            header.first_row = i;
            return header;
        }
        if (key == "Frame") {
            header.has_time = true;
            return header;
        }
        if (const Result<void> read = read_entry(header, fields, lines[i].number, path); !read) return read.error();
    }
    return header;
}

/// Checks the names, and the header counts against the content of the file.
Result<void> check_header(const QtmHeader& header, std::size_t rows, const std::filesystem::path& path) {
    const auto names = static_cast<double>(header.names.size());
    if (header.names.empty()) return Error{"has no MARKER_NAMES", path.string()};
    std::set<std::string> taken;
    for (const std::string& name : header.names) {
        if (name.empty()) return Error{"MARKER_NAMES holds an empty name", at_line(path, header.names_line)};
        if (!taken.insert(name).second)
            return Error{"MARKER_NAMES holds '" + name + "' twice", at_line(path, header.names_line)};
    }
    if (header.markers.line > 0 && header.markers.value != names) {
        return Error{"NO_OF_MARKERS is " + format_number(header.markers.value, 12) + ", but MARKER_NAMES lists " +
                         std::to_string(header.names.size()),
                     at_line(path, header.markers.line)};
    }
    if (!(header.rate_Hz.value > 0.0) && !header.has_time) {
        return Error{"has no FREQUENCY above 0 and no time column", path.string()};
    }
    if (header.frames.line > 0 && header.frames.value != static_cast<double>(rows)) {
        return Error{"NO_OF_FRAMES is " + format_number(header.frames.value, 12) + ", but the file has " +
                         std::to_string(rows) + " rows",
                     at_line(path, header.frames.line)};
    }
    return {};
}

/// Columns of the rows.
SampleTable qtm_table(const QtmHeader& header, double seconds_per_unit) {
    SampleTable table;
    table.separator = '\t';
    table.metres_per_unit = 1e-3;
    table.seconds_per_unit = seconds_per_unit;
    table.rate_Hz = header.rate_Hz.value;
    table.zero_is_occluded = true;
    table.null_is_occluded = true;
    table.trailing_separator = true;
    // Coordinates start after frame and time, if present.
    const std::size_t first = header.has_time ? 2 : 0;
    if (header.has_time) {
        table.frame_column = 0;
        table.time_column = 1;
        table.column_names = {"Frame", "Time"};
    }
    for (std::size_t i = 0; i < header.names.size(); ++i) {
        table.markers.push_back({header.names[i], {first + 3 * i, first + 3 * i + 1, first + 3 * i + 2}});
        for (const char* axis : {" X", " Y", " Z"}) table.column_names.push_back(header.names[i] + axis);
    }
    table.field_count = first + 3 * header.names.size();
    return table;
}

}  // namespace

Result<Recording> read_qtm_tsv(const std::filesystem::path& path, const TraceSource& source) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    std::vector<TextLine> lines = split_lines(*content);
    if (lines.empty()) return Error{"is empty, expected a Qualisys tsv export", at_line(path, 1)};
    const Result<QtmHeader> header = read_header(lines, path);
    if (!header) return header.error();
    const std::span<const TextLine> rows = std::span<const TextLine>(lines).subspan(header->first_row);

    if (const Result<double> unit = recording_unit("the unit of the format", "mm", source.metres_per_unit,
                                                   path.string());
        !unit)
        return unit.error();
    if (const Result<void> checked = check_header(*header, rows.size(), path); !checked) return checked.error();
    Result<Recording> recording = read_samples(path, rows, qtm_table(*header, source.seconds_per_unit.value_or(1.0)));
    if (!recording || !header->has_time || header->rate_Hz.line == 0) return recording;
    if (const Result<void> rated = set_rate(*recording, "FREQUENCY", header->rate_Hz.value,
                                            at_line(path, header->rate_Hz.line), source.seconds_per_unit.has_value());
        !rated)
        return rated.error();
    return recording;
}

TraceReader qtm_tsv_reader() {
    return {.id = "qtm_tsv",
            .label = "Qualisys TSV",
            .endings = {".tsv"},
            .signature = "begins with NO_OF_FRAMES",
            .has_times = true,
            .recognise = [](std::string_view content) -> std::optional<TraceSource> {
                // Exports may begin with any of these header lines.
                const std::string_view first = first_line(content);
                for (const std::string_view key : {"NO_OF_", "FREQUENCY", "MARKER_NAMES"})
                    if (first.starts_with(key)) return TraceSource{.format = "qtm_tsv"};
                return std::nullopt;
            },
            .read = [](const std::filesystem::path& path,
                       const TraceSource& source) { return read_qtm_tsv(path, source); }};
}

}  // namespace myo::measurement
