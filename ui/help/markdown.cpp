#include "help/markdown.hpp"

#include <algorithm>
#include <cctype>

namespace myo::ui::help {
namespace {

// The part of CommonMark that the manual uses. Source: CommonMark 0.30, https://spec.commonmark.org.
constexpr std::string_view fence = "```";
// Blanks before a line of code, and of fences around it.
constexpr std::size_t code_indent = 4;

/// Number of blanks before a line; its length if there is nothing else.
std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// A line without blanks at its ends, and without the carriage return of Windows.
std::string_view trimmed(std::string_view line) {
    const std::size_t first = indent_of(line), last = line.find_last_not_of(" \r");
    return last == std::string_view::npos || first > last ? std::string_view() : line.substr(first, last - first + 1);
}

/// Length of the sign of a list's item with its space: "* ", "12. "; 0: no item.
std::size_t sign_length(std::string_view line) {
    if (line.starts_with("* ") || line.starts_with("- ")) return 2;
    std::size_t digits = 0;
    while (digits < line.size() && std::isdigit(static_cast<unsigned char>(line[digits])) != 0) ++digits;
    return digits > 0 && line.substr(digits).starts_with(". ") ? digits + 2 : 0;
}

/// Cells of a row between its bars. A bar within a cell is written `\|`.
std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells;
    std::string cell;
    line = trimmed(line).substr(1);
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') {
            cell += line[++i];
        } else if (line[i] == '|') {
            cells.push_back(plain_text(trimmed(cell)));
            cell.clear();
        } else {
            cell += line[i];
        }
    }
    return cells;
}

/// The line between the heading of a table and its rows.
bool is_rule(std::string_view line) { return line.find_first_not_of("|-: ") == std::string_view::npos; }

/// Turns lines into blocks. Text is collected until a line of another kind or an empty one ends it.
class Reader {
public:
    /// Takes the next line of the page. The order of the cases matters: within a fence nothing else has a meaning.
    void take(std::string_view line) {
        const std::string_view text = trimmed(line);
        if (fenced_ || text.starts_with(fence)) return take_fenced(line, text);
        if (text.empty()) return end_text();
        if (continues_code(line)) return add_code(line.substr(code_indent));
        if (text.front() == '#' && indent_of(line) == 0) return take_heading(text);
        if (text.front() == '|') return take_row(text);
        if (const std::size_t sign = sign_length(text); sign > 0) return take_item(line, text, sign);
        // A paragraph begins, or the text of the last block goes on.
        if (!collecting_) blocks_.push_back({}), collecting_ = true;
        std::string& raw = raw_;
        raw += (raw.empty() ? "" : " ") + std::string(text);
    }
    /// Ends the last block, and returns all of them.
    std::vector<Block> end() {
        end_text();
        return std::move(blocks_);
    }

private:
    /// Indented code begins after an empty line, outside lists.
    bool continues_code(std::string_view line) const {
        return indent_of(line) >= code_indent && !collecting_ && !in_list_;
    }
    /// Adds a line of code; lines in a row form one block.
    void add_code(std::string_view line) {
        if (!in_code_) blocks_.push_back({Block::Kind::code, 0, "", {}, {}});
        std::string& text = blocks_.back().text;
        text += (text.empty() ? "" : "\n") + std::string(line);
        in_code_ = true;
    }
    /// A fence begins or ends code; between two fences every line is code.
    void take_fenced(std::string_view line, std::string_view text) {
        if (text.starts_with(fence)) {
            end_text();
            fenced_ = !fenced_;
            return;
        }
        add_code(line);
    }
    /// A heading ends a list.
    void take_heading(std::string_view text) {
        end_text();
        in_list_ = false;
        const std::size_t level = std::min(text.find_first_not_of('#'), text.size());
        blocks_.push_back(
            {Block::Kind::heading, static_cast<int>(level), plain_text(trimmed(text.substr(level))), {}, {}});
    }
    /// A row of a table; the first one begins it.
    void take_row(std::string_view text) {
        if (is_rule(text)) return;
        if (blocks_.empty() || blocks_.back().kind != Block::Kind::table || !in_table_) {
            end_text();
            blocks_.push_back({Block::Kind::table, 0, "", {}, {}});
        }
        in_table_ = true;
        blocks_.back().rows.push_back(cells_of(text));
    }
    /// An item of a list. Its text goes on over the next lines; two blanks of indent make it one of an inner list.
    void take_item(std::string_view line, std::string_view text, std::size_t sign) {
        end_text();
        const bool bullet = text.front() == '*' || text.front() == '-';
        blocks_.push_back({Block::Kind::item,
                           indent_of(line) >= 2 ? 1 : 0,
                           "",
                           bullet ? "\xe2\x80\xa2" : std::string(text.substr(0, sign - 1)),
                           {}});
        raw_ = text.substr(sign);
        collecting_ = in_list_ = true;
    }
    /// Ends a paragraph or item: its marks are removed from the whole text, as emphasis may span lines.
    void end_text() {
        if (collecting_) blocks_.back().text = plain_text(raw_);
        // Only pictures leave nothing.
        if (collecting_ && blocks_.back().text.empty()) blocks_.pop_back();
        // A paragraph after an empty line ends a list.
        if (collecting_ && !blocks_.empty() && blocks_.back().kind == Block::Kind::paragraph) in_list_ = false;
        raw_.clear();
        collecting_ = in_code_ = in_table_ = false;
    }

    std::vector<Block> blocks_;
    std::string raw_;  // text of the last block with its marks, while it is collected
    // What the lines so far are part of: text, fenced code, code, a table, a list.
    bool collecting_ = false, fenced_ = false, in_code_ = false, in_table_ = false, in_list_ = false;
};

}  // namespace

std::string plain_text(std::string_view line) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '`') {
            // Code is kept as it is, stars included.
            const std::size_t end = line.find('`', i + 1);
            if (end == std::string_view::npos) return text + std::string(line.substr(i));
            text += line.substr(i + 1, end - i - 1);
            i = end;
        } else if (c == '[' || (c == '!' && i + 1 < line.size() && line[i + 1] == '[')) {
            const std::size_t middle = line.find("](", i);
            const std::size_t end = middle == std::string_view::npos ? middle : line.find(')', middle);
            // The text begins behind the bracket, for a picture behind "![".
            const std::size_t begin = i + (c == '!' ? 2 : 1);
            // Not a link: brackets of the text, such as those of an interval.
            if (end == std::string_view::npos ||
                line.substr(begin, middle - begin).find('[') != std::string_view::npos) {
                text += c;
                continue;
            }
            // The text of a link may have marks itself.
            if (c == '[') text += plain_text(line.substr(begin, middle - begin));
            i = end;
        } else if (c == '*') {
            // A star between spaces is a product.
            const bool product = i > 0 && line[i - 1] == ' ' && i + 1 < line.size() && line[i + 1] == ' ';
            if (product) text += c;
        } else if (c == '\\' && i + 1 < line.size() && std::ispunct(static_cast<unsigned char>(line[i + 1])) != 0) {
            // A backslash makes a mark a plain sign.
            text += line[++i];
        } else {
            text += c;
        }
    }
    return text;
}

std::vector<Block> read_markdown(std::string_view text) {
    Reader reader;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        // The last line may lack its line break.
        reader.take(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.end();
}

std::size_t find_block(const std::vector<Block>& blocks, std::string_view phrase) {
    const auto holds = [&](const std::string& text) { return text.find(phrase) != std::string::npos; };
    const auto found = std::find_if(blocks.begin(), blocks.end(), [&](const Block& block) {
        return holds(block.text) || std::any_of(block.rows.begin(), block.rows.end(), [&](const auto& row) {
                   return std::any_of(row.begin(), row.end(), holds);
               });
    });
    return static_cast<std::size_t>(found - blocks.begin());
}

}  // namespace myo::ui::help
