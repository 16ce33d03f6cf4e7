#include "measurement/trace_file.hpp"

#include <algorithm>
#include <cassert>

#include "base/files.hpp"
#include "measurement/c3d_reader.hpp"
#include "measurement/qtm_tsv.hpp"
#include "measurement/text_table.hpp"
#include "measurement/trace_csv.hpp"

namespace myo::measurement {
namespace {

constexpr std::string_view separators = ",;\t ";

/// Whether a field is a number or a mark for a missing value.
bool is_value(std::string_view field) {
    double value;
    return field == "NULL" || parse_sample(field, value);
}

/// Source of a table without header: the separator that splits the line into whole markers.
std::optional<TraceSource> headerless(std::string_view line) {
    for (const char separator : separators) {
        const std::vector<std::string_view> fields = split_fields(line, separator);
        if (fields.size() < 3 || fields.size() % 3 != 0 || !std::all_of(fields.begin(), fields.end(), is_value))
            continue;
        TraceSource source{TraceFormat::columns, ColumnLayout{}, std::nullopt};
        source.columns->separator = separator;
        for (std::size_t m = 0; m < fields.size() / 3; ++m)
            source.columns->labels.push_back("marker " + std::to_string(m + 1));
        return source;
    }
    return std::nullopt;
}

}  // namespace

const char* to_string(TraceFormat format) {
    switch (format) {
        case TraceFormat::csv: return "csv";
        case TraceFormat::qtm_tsv: return "qtm_tsv";
        case TraceFormat::c3d: return "c3d";
        case TraceFormat::columns: break;
    }
    return "columns";
}

Result<Recording> read_trace(const std::filesystem::path& path, const TraceSource& source) {
    switch (source.format) {
        case TraceFormat::csv: return read_trace_csv(path);
        case TraceFormat::qtm_tsv: return read_qtm_tsv(path);
        case TraceFormat::c3d: return read_c3d(path, source.metres_per_unit);
        case TraceFormat::columns: break;
    }
    assert(source.columns);
    return read_columns(path, *source.columns);
}

Result<TraceSource> guess_trace_source(const std::filesystem::path& path) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    // A C3D file begins with the number of its parameter block and the byte 0x50.
    if (content->size() > 512 && static_cast<unsigned char>((*content)[1]) == 0x50)
        return TraceSource{TraceFormat::c3d, {}, {}};
    const std::vector<TextLine> lines = split_lines(*content);
    const auto first = std::find_if(lines.begin(), lines.end(),
                                    [](const TextLine& line) { return !trimmed(line.text).empty(); });
    if (first == lines.end()) return Error{"holds no samples", path.string()};
    // Qualisys exports may begin with any of these header lines.
    if (first->text.starts_with("NO_OF_") || first->text.starts_with("FREQUENCY") ||
        first->text.starts_with("MARKER_NAMES"))
        return TraceSource{TraceFormat::qtm_tsv, {}, {}};
    if (trimmed(first->text).starts_with("time_s")) return TraceSource{TraceFormat::csv, {}, {}};
    if (std::optional<TraceSource> table = headerless(first->text)) return *table;
    return Error{
        "is none of the known recordings: C3D, Qualisys TSV, a table that begins with time_s, or x, y, z of each "
        "marker without a header",
        path.string()};
}

}  // namespace myo::measurement
