#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace myo::measurement {

/// A line of a text file without its end, and its number counted from 1.
struct TextLine {
    int number = 0;
    std::string_view text;
};

/// The lines of a text: a byte-order mark is skipped, CR LF and LF both end a line, blank lines at the end are left
/// out.
std::vector<TextLine> split_lines(std::string_view content);

/// The fields of a line, blanks around them removed. A separator inside double quotes does not separate, quotes around
/// a field are dropped; when the separator is a blank, several of them count as one.
std::vector<std::string_view> split_fields(std::string_view line, char separator);

/// A text of a field without blanks around it.
std::string_view trimmed(std::string_view text);

/// A finite number, or NaN for "nan" and for an empty field; false for anything else, infinities included.
bool parse_sample(std::string_view field, double& value);

/// "file:line"
std::string at_line(const std::filesystem::path& path, int line);

/// Decimal text that reads back as the same double; "nan" for NaN. Locale-free.
std::string exact_number(double value);

}  // namespace myo::measurement
