#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace myo::measurement {

/// A line of a text file without its line ending.
struct TextLine {
    int number = 0;         // from 1
    std::string_view text;  // refers to the content passed to split_lines()
};

/// Lines of a text. A byte-order mark is skipped, CR LF and LF both end a line, blank lines at the end are dropped.
std::vector<TextLine> split_lines(std::string_view content);

/// Fields of a line without surrounding blanks. Separators within double quotes do not separate, and quotes around a
/// field are removed. With a blank as separator, consecutive blanks count as one.
std::vector<std::string_view> split_fields(std::string_view line, char separator);

/// Text without surrounding blanks, tabs and carriage returns.
std::string_view trimmed(std::string_view text);

/// Parses a finite number; NaN for "nan" and for an empty field. Returns false otherwise, also for infinities.
bool parse_sample(std::string_view field, double& value);

/// Position in a file for messages: "file:line".
std::string at_line(const std::filesystem::path& path, int line);

/// Shortest decimal text that reads back as the same double; "nan" for NaN. Independent of the locale.
std::string exact_number(double value);

}  // namespace myo::measurement
