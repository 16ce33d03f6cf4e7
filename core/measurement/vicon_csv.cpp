#include "measurement/vicon_csv.hpp"

#include <algorithm>

#include "base/files.hpp"
#include "base/text.hpp"
#include "measurement/marker_labels.hpp"
#include "measurement/sample_table.hpp"
#include "measurement/units.hpp"

namespace myo::measurement {
namespace {

constexpr std::string_view trajectories = "Trajectories";

/// Rows of the section from its title on; that of the units may be missing.
enum SectionRow : std::size_t { rate_row = 1, subject_row = 2, frame_row = 3, unit_row = 4, header_rows = 5 };

/// Text without separators at its ends: spreadsheets fill short lines with them.
std::string_view bare(std::string_view text) {
    const auto is_filler = [](char c) { return c == ',' || c == ';' || c == '\t' || c == ' ' || c == '\r'; };
    while (!text.empty() && is_filler(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_filler(text.back())) text.remove_suffix(1);
    return text;
}

/// Lines of the section, from its title to the blank line behind it; empty if there is none.
std::span<const TextLine> section_of(const std::vector<TextLine>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (bare(lines[i].text) != trajectories) continue;
        // The row of units may be blank.
        std::size_t end = std::min(i + header_rows, lines.size());
        while (end < lines.size() && !bare(lines[end].text).empty()) ++end;
        return std::span(lines).subspan(i, end - i);
    }
    return {};
}

/// Columns of X, Y and Z behind each name.
Result<std::vector<MarkerColumns>> vicon_markers(const std::vector<std::string_view>& subjects,
                                                 const std::vector<std::string_view>& axes, const std::string& where) {
    std::vector<MarkerColumns> markers;
    std::vector<std::string> labels;
    for (std::size_t c = 2; c < axes.size(); ++c) {
        if (c < subjects.size() && !subjects[c].empty()) {
            markers.push_back({std::string(subjects[c]), {0, 0, 0}});
            labels.push_back(markers.back().label);
        }
        if (const std::size_t k = std::string_view("XYZ").find(axes[c]);
            axes[c].size() == 1 && k < 3 && !markers.empty())
            markers.back().columns[k] = c;
    }
    if (markers.empty()) return Error{"names no marker", where};
    make_unique(labels);
    for (std::size_t i = 0; i < markers.size(); ++i) {
        markers[i].label = labels[i];
        for (std::size_t k = 0; k < 3; ++k)
            if (markers[i].columns[k] == 0) return Error{"marker '" + labels[i] + "' has no column " + "XYZ"[k], where};
    }
    return markers;
}

/// Metres per unit of all coordinates.
Result<double> vicon_unit(const std::vector<std::string_view>& units, const std::vector<MarkerColumns>& markers,
                          std::optional<double> declared, const std::string& where) {
    std::optional<std::string> stated;
    for (const MarkerColumns& marker : markers)
        for (const std::size_t column : marker.columns) {
            const std::string own(column < units.size() ? units[column] : std::string_view());
            if (stated && own != *stated)
                return Error{"has coordinates in '" + *stated + "' and in '" + own + "'", where};
            stated = own;
        }
    return recording_unit("the row of units", stated.value_or(""), declared, where);
}

/// How to read the rows; the unit and the rate are known.
SampleTable vicon_table(std::vector<MarkerColumns> markers, const std::vector<std::string_view>& axes, char separator,
                        double metres_per_unit, double rate_Hz) {
    SampleTable table;
    table.separator = separator;
    table.decimal_comma = separator != ',';
    table.metres_per_unit = metres_per_unit;
    table.time_column = 0;
    table.seconds_per_unit = 1.0 / rate_Hz;
    table.rate_Hz = rate_Hz;
    table.field_count = axes.size();
    table.ragged = true;
    for (const std::string_view axis : axes) table.column_names.emplace_back(axis);
    for (const MarkerColumns& marker : markers)
        for (const std::size_t column : marker.columns)
            table.column_names[column] = marker.label + " " + table.column_names[column];
    table.markers = std::move(markers);
    return table;
}

}  // namespace

Result<Recording> read_vicon_csv(const std::filesystem::path& path, const TraceSource& source) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    const std::vector<TextLine> lines = split_lines(*content);
    const std::span<const TextLine> section = section_of(lines);
    if (section.empty()) return Error{"has no section " + std::string(trajectories), path.string()};
    const auto where = [&](std::size_t row) {
        return at_line(path, section[std::min(row, section.size() - 1)].number);
    };
    if (section.size() < header_rows)
        return Error{"ends within the header of the section " + std::string(trajectories), where(section.size() - 1)};
    double rate_Hz = 0.0;
    const std::string_view rate = bare(section[rate_row].text);
    if (!parse_number(rate, rate_Hz) || !(rate_Hz > 0.0))
        return Error{"the rate is '" + std::string(rate) + "', expected a number above 0", where(rate_row)};
    const std::string_view frames = section[frame_row].text;
    constexpr std::string_view frame = "Frame";
    if (!frames.starts_with(frame) || frames.size() == frame.size())
        return Error{"the columns do not begin with Frame and Sub Frame", where(frame_row)};
    const char separator = frames[frame.size()];
    const std::vector<std::string_view> axes = split_fields(frames, separator);
    Result<std::vector<MarkerColumns>> markers = vicon_markers(split_fields(section[subject_row].text, separator), axes,
                                                               where(subject_row));
    if (!markers) return markers.error();
    std::vector<std::string_view> units = split_fields(section[unit_row].text, separator);
    double first = 0.0;
    const bool has_units = !parse_number(units[0], first);
    if (!has_units) units.clear();
    const Result<double> metres = vicon_unit(units, *markers, source.metres_per_unit, where(unit_row));
    if (!metres) return metres.error();
    const SampleTable table = vicon_table(std::move(*markers), axes, separator, *metres, rate_Hz);
    Result<Recording> recording = read_samples(path, section.subspan(has_units ? header_rows : unit_row), table);
    // Frames of a cut trial do not begin at 1.
    if (recording) recording->time_s.array() -= recording->time_s(0);
    return recording;
}

TraceReader vicon_csv_reader() {
    return {.id = "vicon_csv",
            .label = "Nexus CSV",
            .endings = {".csv"},
            .signature = "has a line " + std::string(trajectories),
            .of_cameras = true,
            .with_other_markers = true,
            .may_lack_unit = true,
            .recognise = [](std::string_view content) -> std::optional<TraceSource> {
                if (content.find(trajectories) == std::string_view::npos || section_of(split_lines(content)).empty())
                    return std::nullopt;
                return TraceSource{.format = "vicon_csv"};
            },
            .read = [](const std::filesystem::path& path,
                       const TraceSource& source) { return read_vicon_csv(path, source); }};
}

}  // namespace myo::measurement
