#include "measurement/trace_file.hpp"

#include <algorithm>
#include <cassert>

#include "base/files.hpp"
#include "base/letter_case.hpp"
#include "measurement/text_table.hpp"

namespace myo::measurement {

/// One line per format: the name of the function that its file defines. Formats with a signature of their own come
/// first.
// clang-format off
#define MYOLOOP_TRACE_READERS(entry) \
    entry(c3d_reader) \
    entry(motive_csv_reader) \
    entry(qtm_tsv_reader) \
    entry(trace_csv_reader) \
    entry(trc_reader) \
    entry(vicon_csv_reader) \
    entry(columns_reader)
// clang-format on

#define MYOLOOP_DECLARE(name) TraceReader name();
MYOLOOP_TRACE_READERS(MYOLOOP_DECLARE)
#undef MYOLOOP_DECLARE

const std::vector<TraceReader>& trace_readers() {
#define MYOLOOP_CALL(name) name(),
    static const std::vector<TraceReader> readers = {MYOLOOP_TRACE_READERS(MYOLOOP_CALL)};
#undef MYOLOOP_CALL
    return readers;
}

const TraceReader* find_trace_reader(const std::string& id) {
    for (const TraceReader& reader : trace_readers())
        if (reader.id == id) return &reader;
    return nullptr;
}

std::vector<std::string> trace_formats() {
    std::vector<std::string> ids;
    for (const TraceReader& reader : trace_readers()) ids.push_back(reader.id);
    return ids;
}

std::vector<std::string> trace_endings() {
    std::vector<std::string> endings;
    for (const TraceReader& reader : trace_readers())
        for (const std::string& ending : reader.endings)
            if (std::find(endings.begin(), endings.end(), ending) == endings.end()) endings.push_back(ending);
    return endings;
}

bool has_trace_ending(const std::filesystem::path& path) {
    const std::vector<std::string> endings = trace_endings();
    return std::find(endings.begin(), endings.end(), lower_case(path.extension().string())) != endings.end();
}

Result<Recording> read_trace(const std::filesystem::path& path, const TraceSource& source) {
    const TraceReader* const reader = find_trace_reader(source.format);
    assert(reader != nullptr);
    return reader->read(path, source);
}

Result<TraceSource> guess_trace_source(const std::filesystem::path& path) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    std::string known;
    for (const TraceReader& reader : trace_readers()) {
        if (std::optional<TraceSource> source = reader.recognise(*content)) return *source;
        known += (known.empty() ? "" : ", ") + reader.label + " (" + reader.signature + ")";
    }
    if (trimmed(*content).empty()) return Error{"holds no samples", path.string()};
    return Error{"is none of the known recordings: " + known, path.string()};
}

// Each reader asks, so the rest of a long file is not split.
std::string_view first_line(std::string_view content) {
    for (std::size_t begin = 0; begin < content.size();) {
        const std::size_t end = std::min(content.find('\n', begin), content.size());
        const std::vector<TextLine> lines = split_lines(content.substr(begin, end - begin));
        if (!lines.empty() && !trimmed(lines.front().text).empty()) return lines.front().text;
        begin = end + 1;
    }
    return {};
}

}  // namespace myo::measurement
