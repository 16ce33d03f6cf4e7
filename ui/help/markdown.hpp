#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace myo::ui::help {

/// A part of a page of markdown, as it is drawn. Texts are plain: without the marks of emphasis, code and links.
struct Block {
    enum class Kind { heading, paragraph, item, code, table };
    Kind kind = Kind::paragraph;                 // decides which of the following are set
    int level = 0;                               // of a heading, 1 to 6; of an item, 0 for the outermost list
    std::string text;                            // of a code block with its line breaks
    std::string sign = {};                       // of an item: "•" or "3."
    std::vector<std::vector<std::string>> rows;  // of a table; the first row is its heading
};

/// Blocks of a page, in order: headings, paragraphs, lists, code (fenced or indented) and tables. Pictures are left
/// out.
std::vector<Block> read_markdown(std::string_view text);

/// A line without the marks of emphasis, code and links; a link becomes its text, a picture nothing. Text between
/// backticks is kept as it is.
std::string plain_text(std::string_view line);

/// Index of the first block that contains a phrase, in its text or in a cell of its table; `blocks.size()` if none
/// does. Upper and lower case differ.
std::size_t find_block(const std::vector<Block>& blocks, std::string_view phrase);

}  // namespace myo::ui::help
