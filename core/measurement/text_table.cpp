#include "measurement/text_table.hpp"

#include <charconv>
#include <cmath>
#include <limits>

#include "base/text.hpp"

namespace myo::measurement {

std::string_view trimmed(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

std::vector<TextLine> split_lines(std::string_view content) {
    // Byte-order mark of UTF-8.
    if (content.substr(0, 3) == "\xEF\xBB\xBF") content.remove_prefix(3);
    std::vector<TextLine> lines;
    int number = 0;
    while (!content.empty()) {
        const std::size_t end = content.find('\n');
        std::string_view line = content.substr(0, end);
        content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        lines.push_back({++number, line});
    }
    while (!lines.empty() && trimmed(lines.back().text).empty()) lines.pop_back();
    return lines;
}

std::vector<std::string_view> split_fields(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    if (separator == ' ') line = trimmed(line);
    bool quoted = false;
    std::size_t start = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i < line.size() && line[i] == '"') quoted = !quoted;
        if (i < line.size() && (quoted || line[i] != separator)) continue;
        std::string_view field = trimmed(line.substr(start, i - start));
        // Quotes are removed after trimming, so that blanks within them stay.
        if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
        start = i + 1;
        // Consecutive blanks are one separator.
        if (separator == ' ' && field.empty()) continue;
        fields.push_back(field);
    }
    return fields;
}

bool parse_sample(std::string_view field, double& value) {
    field = trimmed(field);
    if (field.empty()) {
        value = std::numeric_limits<double>::quiet_NaN();
        return true;
    }
    return parse_number(field, value) && !std::isinf(value);
}

std::string at_line(const std::filesystem::path& path, int line) { return path.string() + ":" + std::to_string(line); }

std::string exact_number(double value) {
    if (std::isnan(value)) return "nan";
    char buffer[32];
    // to_chars gives the shortest exact representation.
    const auto [end, code] = std::to_chars(buffer, buffer + sizeof buffer, value);
    return code == std::errc{} ? std::string(buffer, end) : std::string("nan");
}

}  // namespace myo::measurement
