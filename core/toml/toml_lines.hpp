#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "toml/toml_layout.hpp"

namespace myo::toml {

// Lines of a TOML text, and which comments belong to which statement.

/// New text for a range of a text; an empty range inserts.
struct Replacement {
    TextRange range;
    std::string text;
};

/// Text with all replacements made. The ranges must not overlap; ranges refer to the text before.
std::string replaced(const std::string& text, std::vector<Replacement> replacements);

/// Line end of a text, taken from its first line.
std::string line_end_of(const std::string& text);
/// `lines` with the given line end.
std::string with_line_ends(const std::string& lines, const std::string& line_end);

/// First byte of the line that holds `at`.
std::size_t line_begin(const std::string& text, std::size_t at);
/// First byte of the next line.
std::size_t next_line(const std::string& text, std::size_t at);
/// Blanks at the beginning of the line that holds `at`.
std::string indentation(const std::string& text, std::size_t at);
/// True if the line that begins at `at` holds blanks only. False at the end of the text.
bool is_blank_line(const std::string& text, std::size_t at);
/// True if the line above is blank, or there is none.
bool follows_blank_line(const std::string& text, const TomlLayout& layout, std::size_t at);

/// Begin of a statement with the comment lines directly above.
std::size_t begin_with_comments(const std::string& text, const TomlLayout& layout, std::size_t statement);
/// End of a statement with the comment lines directly below, except those directly above the next statement.
std::size_t end_with_comments(const std::string& text, const TomlLayout& layout, std::size_t statement);

/// Inserts whole lines, which end in "\n", at the begin of a line. They get the line end of the text. At the end of a
/// text without line end, the result has none either.
Replacement inserted_lines(const std::string& text, std::size_t at, const std::string& lines);

}  // namespace myo::toml
