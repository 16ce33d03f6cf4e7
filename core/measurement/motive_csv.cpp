#include "measurement/motive_csv.hpp"

#include <algorithm>
#include <map>

#include "base/files.hpp"
#include "base/text.hpp"
#include "measurement/marker_labels.hpp"
#include "measurement/sample_table.hpp"
#include "measurement/units.hpp"

namespace myo::measurement {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::string_view motive_signature = "Format Version";

/// Rows of the header, split into fields.
struct MotiveHeader {
    std::map<std::string_view, std::string_view> values;  // of the first line
    Fields types, names, ids, kinds, axes;
    std::size_t axes_line = 0;  // index of the row `Frame, Time, X, ...`
};

/// Field of a row; empty beyond its end.
std::string_view field_of(const Fields& fields, std::size_t column) {
    return column < fields.size() ? fields[column] : std::string_view();
}

Result<MotiveHeader> read_motive_header(const std::vector<TextLine>& lines, const std::filesystem::path& path) {
    MotiveHeader header;
    const Fields first = lines.empty() ? Fields{} : split_fields(lines[0].text, ',');
    if (field_of(first, 0) != motive_signature)
        return Error{"is no Motive export: its first line begins with " + std::string(motive_signature),
                     at_line(path, 1)};
    for (std::size_t i = 0; i + 1 < first.size(); i += 2) header.values.emplace(first[i], first[i + 1]);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        Fields fields = split_fields(lines[i].text, ',');
        const std::string_view key = field_of(fields, 1);
        if (fields[0] == "Frame") {
            header.axes = std::move(fields);
            header.axes_line = i;
            break;
        }
        // The row of kinds has no key; it is the last one before the axes.
        if (key == "Type")
            header.types = std::move(fields);
        else if (key == "Name")
            header.names = std::move(fields);
        else if (key == "ID")
            header.ids = std::move(fields);
        else if (key.empty())
            header.kinds = std::move(fields);
    }
    if (header.axes_line == 0) return Error{"has no row that begins with Frame", path.string()};
    for (const auto& [name, row] : {std::pair{"Type", &header.types}, {"Name", &header.names}})
        if (row->empty()) return Error{"has no row " + std::string(name) + " in its header", path.string()};
    if (!field_of(header.axes, 1).starts_with("Time"))
        return Error{"has no column Time behind Frame", at_line(path, lines[header.axes_line].number)};
    return header;
}

/// Columns of the markers of a type. The rows of one marker have one name and one ID.
Result<std::vector<MarkerColumns>> columns_of_type(const MotiveHeader& header, bool labelled,
                                                   const std::string& where) {
    std::vector<MarkerColumns> markers;
    std::map<std::pair<std::string_view, std::string_view>, std::size_t> places;
    for (std::size_t c = 2; c < header.axes.size(); ++c) {
        const std::string_view type = field_of(header.types, c), axis = header.axes[c];
        const bool wanted = labelled ? type == "Marker" : type.ends_with("Marker");
        if (!wanted || field_of(header.kinds, c) != "Position" || axis.size() != 1) continue;
        const std::string_view name = field_of(header.names, c);
        const auto [place, is_new] = places.emplace(std::pair{name, field_of(header.ids, c)}, markers.size());
        // Column 0 is that of the frames, and therefore free to mean "missing".
        if (is_new) markers.push_back({std::string(name), {0, 0, 0}});
        if (const std::size_t k = std::string_view("XYZ").find(axis); k < 3) markers[place->second].columns[k] = c;
    }
    for (const MarkerColumns& marker : markers)
        for (std::size_t k = 0; k < 3; ++k)
            if (marker.columns[k] == 0) return Error{"marker '" + marker.label + "' has no column " + "XYZ"[k], where};
    return markers;
}

Result<std::vector<MarkerColumns>> motive_markers(const MotiveHeader& header, const std::string& where) {
    for (const bool labelled : {true, false}) {
        Result<std::vector<MarkerColumns>> markers = columns_of_type(header, labelled, where);
        if (!markers || markers->empty()) {
            if (!markers) return markers;
            continue;
        }
        std::vector<std::string> labels;
        for (const MarkerColumns& marker : *markers) labels.push_back(marker.label);
        make_unique(labels);
        for (std::size_t i = 0; i < labels.size(); ++i) (*markers)[i].label = labels[i];
        return markers;
    }
    return Error{"has no column of type Marker with a position", where};
}

/// Rate of the export; 0 if the first line does not state it.
Result<double> motive_rate(const MotiveHeader& header, const std::string& where, std::string& field) {
    for (const char* const key : {"Export Frame Rate", "Capture Frame Rate"}) {
        const auto found = header.values.find(key);
        if (found == header.values.end()) continue;
        field = key;
        double rate_Hz = 0.0;
        if (!parse_number(found->second, rate_Hz) || !(rate_Hz > 0.0))
            return Error{field + " is '" + std::string(found->second) + "', expected a number above 0", where};
        return rate_Hz;
    }
    return 0.0;
}

}  // namespace

Result<Recording> read_motive_csv(const std::filesystem::path& path, const TraceSource& source) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    const std::vector<TextLine> lines = split_lines(*content);
    const Result<MotiveHeader> header = read_motive_header(lines, path);
    if (!header) return header.error();
    const std::string where = at_line(path, 1);
    const auto unit = header->values.find("Length Units");
    const Result<double> metres = recording_unit(
        "Length Units", std::string(unit == header->values.end() ? std::string_view() : unit->second),
        source.metres_per_unit, where);
    if (!metres) return metres.error();
    std::string rate_field;
    const Result<double> rate_Hz = motive_rate(*header, where, rate_field);
    if (!rate_Hz) return rate_Hz.error();
    Result<std::vector<MarkerColumns>> markers = motive_markers(*header,
                                                                at_line(path, lines[header->axes_line].number));
    if (!markers) return markers.error();

    SampleTable table;
    table.markers = std::move(*markers);
    table.metres_per_unit = *metres;
    table.frame_column = 0;
    table.time_column = 1;
    table.seconds_per_unit = source.seconds_per_unit.value_or(1.0);
    table.field_count = header->axes.size();
    table.ragged = true;
    for (std::size_t c = 0; c < table.field_count; ++c)
        table.column_names.push_back(std::string(field_of(header->names, c)) + " " + std::string(header->axes[c]));
    Result<Recording> recording = read_samples(path, std::span(lines).subspan(header->axes_line + 1), table);
    if (!recording || *rate_Hz == 0.0) return recording;
    if (const Result<void> rated = set_rate(*recording, rate_field, *rate_Hz, where,
                                            source.seconds_per_unit.has_value());
        !rated)
        return rated.error();
    return recording;
}

TraceReader motive_csv_reader() {
    return {.id = "motive_csv",
            .label = "Motive CSV",
            .endings = {".csv"},
            .signature = "begins with " + std::string(motive_signature),
            .of_cameras = true,
            .with_other_markers = true,
            .may_lack_unit = true,
            .has_times = true,
            .is_y_up = true,
            .recognise = [](std::string_view content) -> std::optional<TraceSource> {
                if (!first_line(content).starts_with(motive_signature)) return std::nullopt;
                return TraceSource{.format = "motive_csv"};
            },
            .read = [](const std::filesystem::path& path,
                       const TraceSource& source) { return read_motive_csv(path, source); }};
}

}  // namespace myo::measurement
