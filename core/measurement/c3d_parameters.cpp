#include "measurement/c3d_parameters.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace myo::measurement {
namespace {

/// A parameter whose group name is not yet known.
struct PendingParameter {
    int group = 0;
    std::string name;
    C3dParameter parameter;
};

std::string capitals(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return result;
}

std::string at_byte(std::size_t offset) { return "at byte " + std::to_string(offset); }

/// Bytes per value.
std::size_t value_size(C3dParameter::Type type) {
    switch (type) {
        case C3dParameter::Type::text:
        case C3dParameter::Type::byte: return 1;
        case C3dParameter::Type::word: return 2;
        case C3dParameter::Type::real: return 4;
    }
    return 1;
}

/// Type of a code byte of the format; false if unknown.
bool type_of_code(int code, C3dParameter::Type& type) {
    switch (code) {
        case -1: type = C3dParameter::Type::text; return true;
        case 1: type = C3dParameter::Type::byte; return true;
        case 2: type = C3dParameter::Type::word; return true;
        case 4: type = C3dParameter::Type::real; return true;
        default: return false;
    }
}

// Body of a parameter record from `offset`, after the word that points to the next record.
Result<C3dParameter> read_body(const C3dWords& words, std::size_t offset, const std::string& name,
                               const std::string& file) {
    const auto cut_off = [&] {
        return Error{"parameter " + name + " " + at_byte(offset) + " runs over the end of the file", file};
    };
    if (!words.holds(offset, 2)) return cut_off();
    C3dParameter parameter;
    if (!type_of_code(words.signed_byte(offset), parameter.type)) {
        return Error{"parameter " + name + " " + at_byte(offset) + " has the unknown type " +
                         std::to_string(int{words.signed_byte(offset)}) + "; the parameter section is damaged",
                     file};
    }
    const std::size_t dimension_count = words.byte(offset + 1);
    if (!words.holds(offset + 2, dimension_count)) return cut_off();
    parameter.offset = offset + 2 + dimension_count;
    parameter.count = 1;
    for (std::size_t d = 0; d < dimension_count; ++d) {
        const std::size_t extent = words.byte(offset + 2 + d);
        parameter.dimensions.push_back(extent);
        parameter.count *= extent;
        if (parameter.count > words.size()) return cut_off();  // also keeps the product from overflowing
    }
    if (!words.holds(parameter.offset, parameter.count * value_size(parameter.type))) return cut_off();
    return parameter;
}

// Length of the UTF-8 character at the start of `text`; 0 if the bytes are not UTF-8.
std::size_t utf8_length(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) return 0;
    }
    if (length > 2) {  // excludes overlong forms, surrogates and values above U+10FFFF
        const auto second = static_cast<unsigned char>(text[1]);
        if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0) || (lead == 0xF0 && second < 0x90) ||
            (lead == 0xF4 && second >= 0x90))
            return 0;
    }
    return length;
}

Error damaged_record(std::size_t at, const std::string& what, const std::string& file) {
    return {"the parameter record " + at_byte(at) + " " + what + "; the parameter section is damaged", file};
}

/// Parameters by GROUP:NAME. A parameter may precede the record that names its group, so names are resolved at the end.
std::map<std::string, C3dParameter> with_group_names(const std::map<int, std::string>& groups,
                                                     const std::vector<PendingParameter>& pending) {
    std::map<std::string, C3dParameter> entries;
    for (const PendingParameter& entry : pending) {
        const auto group = groups.find(entry.group);
        if (group != groups.end()) entries[group->second + ":" + entry.name] = entry.parameter;
    }
    return entries;
}

/// Reads a record. Negative group number: definition of a group; positive: parameter of that group.
Result<void> read_record(const C3dWords& words, std::size_t pointer, int group, const std::string& name,
                         std::map<int, std::string>& groups, std::vector<PendingParameter>& pending, std::size_t at,
                         const std::string& file) {
    if (group == 0) return damaged_record(at, "belongs to no group", file);
    if (group < 0) {
        groups[-group] = name;
        return {};
    }
    Result<C3dParameter> parameter = read_body(words, pointer + 2, name, file);
    if (!parameter) return parameter.error();
    pending.push_back({group, name, *parameter});
    return {};
}

/// End of the declared blocks [bytes]; some writers declare none.
std::size_t end_of_section(const C3dWords& words, std::size_t start) {
    const std::size_t blocks = words.holds(start, 4) ? words.byte(start + 2) : 0;
    return blocks > 0 ? start + blocks * c3d_format.block_size : words.size();
}

std::size_t end_of_values(const C3dParameter& parameter) {
    return parameter.offset + parameter.count * value_size(parameter.type);
}

}  // namespace

std::string clean_c3d_text(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\0' || c == '\r' || c == '\n'; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const auto c = static_cast<unsigned char>(text[0]);
        // Invalid byte: encode its Latin-1 code point as two bytes of UTF-8.
        if (length == 0) {
            result += static_cast<char>(0xC0U | (c >> 6U));
            result += static_cast<char>(0x80U | (c & 0x3FU));
        } else if (length > 1 || (c >= 0x20 && c != 0x7F)) {
            result += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

std::optional<double> C3dParameters::number(const std::string& name, std::size_t i) const {
    const auto found = entries_.find(name);
    if (found == entries_.end() || i >= found->second.count) return std::nullopt;
    const C3dParameter& parameter = found->second;
    const std::size_t offset = parameter.offset + i * value_size(parameter.type);
    switch (parameter.type) {
        case C3dParameter::Type::text: return std::nullopt;
        case C3dParameter::Type::byte: return static_cast<double>(words_.byte(offset));
        case C3dParameter::Type::word: return static_cast<double>(words_.word(offset));
        case C3dParameter::Type::real: return words_.real(offset);
    }
    return std::nullopt;
}

bool C3dParameters::is_word(const std::string& name) const {
    const auto found = entries_.find(name);
    return found != entries_.end() && found->second.type == C3dParameter::Type::word;
}

std::vector<std::string> C3dParameters::texts(const std::string& name) const {
    std::vector<std::string> result;
    const auto found = entries_.find(name);
    if (found == entries_.end() || found->second.type != C3dParameter::Type::text) return result;
    const C3dParameter& parameter = found->second;
    // The first dimension is the length of each string.
    const std::size_t length = parameter.dimensions.empty() ? 1 : parameter.dimensions[0];
    if (length == 0) return result;
    for (std::size_t i = 0; i + length <= parameter.count; i += length) {
        result.push_back(clean_c3d_text(words_.text(parameter.offset + i, length)));
    }
    return result;
}

Result<C3dParameters> read_c3d_parameters(const C3dWords& words, std::size_t start, const std::string& file) {
    std::map<int, std::string> groups;
    std::vector<PendingParameter> pending;
    // Records are chained by offsets. Each offset moves forward, so the loop terminates.
    // The section begins with four bytes: two reserved, number of blocks, processor.
    std::size_t at = start + 4;
    const std::size_t end = end_of_section(words, start);
    while (at < end && words.holds(at, 2) && words.byte(at) != 0) {
        const auto name_length = static_cast<std::size_t>(
            std::abs(int{words.signed_byte(at)}));  // a negative length marks a locked record
        const int group = int{words.signed_byte(at + 1)};
        const std::size_t pointer = at + 2 + name_length;
        if (!words.holds(pointer, 2))
            return Error{"the parameter record " + at_byte(at) + " runs over the end of the file", file};
        const std::string name = capitals(clean_c3d_text(words.text(at + 2, name_length)));
        const std::size_t step = words.word(pointer);
        // Without an end mark, the bytes behind the last record look like one that leaves the declared blocks. The last
        // record itself may point there, but its values lie inside.
        const bool leaves_section = pointer + step > end;
        if (leaves_section && group <= 0) break;
        const Result<void> read = read_record(words, pointer, group, name, groups, pending, at, file);
        if (leaves_section) {
            if (read && end_of_values(pending.back().parameter) > end) pending.pop_back();
            break;
        }
        if (!read) return read.error();
        if (step == 0) break;  // end mark of some writers
        if (step < 2) return damaged_record(at, "points into itself", file);
        at = pointer + step;
    }
    return C3dParameters(words, with_group_names(groups, pending));
}

}  // namespace myo::measurement
