#include "toml/toml_lines.hpp"

#include <algorithm>

namespace myo::toml {
namespace {

// First byte of a line that is no blank.
char first_character(const std::string& text, std::size_t at) {
    const std::size_t found = text.find_first_not_of(" \t", at);
    return found == std::string::npos ? '\0' : text[found];
}

}  // namespace

std::string replaced(const std::string& text, std::vector<Replacement> replacements) {
    std::stable_sort(replacements.begin(), replacements.end(),
                     [](const Replacement& a, const Replacement& b) { return a.range.begin < b.range.begin; });
    std::string result;
    std::size_t at = 0;
    for (const Replacement& replacement : replacements) {
        result += text.substr(at, replacement.range.begin - at) + replacement.text;
        at = replacement.range.end;
    }
    return result + text.substr(at);
}

std::string line_end_of(const std::string& text) {
    const std::size_t end = text.find('\n');
    return end != std::string::npos && end > 0 && text[end - 1] == '\r' ? "\r\n" : "\n";
}

std::string with_line_ends(const std::string& lines, const std::string& line_end) {
    std::string result;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i] == '\n')
            result += line_end;
        else if (lines[i] != '\r' || i + 1 == lines.size() || lines[i + 1] != '\n')
            result += lines[i];
    }
    return result;
}

std::size_t line_begin(const std::string& text, std::size_t at) {
    const std::size_t end = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    return end == std::string::npos ? 0 : end + 1;
}

std::size_t next_line(const std::string& text, std::size_t at) {
    const std::size_t end = text.find('\n', at);
    return end == std::string::npos ? text.size() : end + 1;
}

std::string indentation(const std::string& text, std::size_t at) {
    const std::size_t begin = line_begin(text, at);
    return text.substr(begin, std::min(text.find_first_not_of(" \t", begin), text.size()) - begin);
}

bool is_blank_line(const std::string& text, std::size_t at) {
    const std::size_t found = text.find_first_not_of(" \t\r", at);
    return at < text.size() && (found == std::string::npos || text[found] == '\n');
}

bool follows_blank_line(const std::string& text, const TomlLayout& layout, std::size_t at) {
    return at <= layout.begin || (text[at - 1] == '\n' && is_blank_line(text, line_begin(text, at - 1)));
}

std::size_t begin_with_comments(const std::string& text, const TomlLayout& layout, std::size_t statement) {
    const std::size_t lowest = statement == 0 ? layout.begin : layout.statements[statement - 1].lines.end;
    std::size_t begin = layout.statements[statement].lines.begin;
    while (begin > lowest) {
        const std::size_t above = std::max(line_begin(text, begin - 1), lowest);
        if (first_character(text, above) != '#') break;
        begin = above;
    }
    return begin;
}

std::size_t end_with_comments(const std::string& text, const TomlLayout& layout, std::size_t statement) {
    const std::size_t own_end = layout.statements[statement].lines.end;
    const bool last = statement + 1 == layout.statements.size();
    const std::size_t highest = last ? text.size() : layout.statements[statement + 1].lines.begin;
    std::size_t end = own_end;
    while (end < highest && first_character(text, end) == '#') end = next_line(text, end);
    return end == highest && !last ? own_end : end;
}

Replacement inserted_lines(const std::string& text, std::size_t at, const std::string& lines) {
    const std::string line_end = line_end_of(text);
    std::string inserted = with_line_ends(lines, line_end);
    // A last line without line end.
    const bool within_line = at > 0 && at == text.size() && line_begin(text, at) != at;
    if (within_line) inserted = line_end + inserted.substr(0, inserted.size() - line_end.size());
    return {{at, at}, inserted};
}

}  // namespace myo::toml
