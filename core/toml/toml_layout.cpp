#include "toml/toml_layout.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include "toml/toml_value.hpp"

namespace myo::toml {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t";

// Reads a valid text from its beginning to its end. Valid text needs few cases: a value that is neither a string nor in
// brackets ends at the next delimiter.
class LayoutScanner {
public:
    explicit LayoutScanner(const std::string& text) : text_(text) {}

    TomlLayout scan() {
        TomlLayout layout;
        if (text_.starts_with(byte_order_mark)) layout.begin = at_ = byte_order_mark.size();
        TomlPath section;
        for (skip_space_and_comments(); !at_end(); skip_space_and_comments()) {
            const std::size_t before = at_;
            Statement statement = next() == '[' ? header() : assignment(section);
            if (at_ == before) break;  // not valid
            if (statement.is_header()) section = statement.path;
            const std::size_t last_line_end = before == 0 ? std::string::npos : text_.rfind('\n', before - 1);
            statement.lines.begin = last_line_end == std::string::npos ? layout.begin : last_line_end + 1;
            skip_line();
            statement.lines.end = at_;
            layout.statements.push_back(std::move(statement));
        }
        return layout;
    }

private:
    bool at_end() const { return at_ >= text_.size(); }
    char next() const { return at_end() ? '\0' : text_[at_]; }
    bool next_is(std::string_view what) const { return std::string_view(text_).substr(at_).starts_with(what); }
    void skip(std::size_t count) { at_ = std::min(at_ + count, text_.size()); }
    void skip_all_of(std::string_view characters) {
        at_ = std::min(text_.find_first_not_of(characters, at_), text_.size());
    }
    void skip_line() {
        at_ = std::min(text_.find('\n', at_), text_.size());
        skip(1);
    }
    void skip_space_and_comments() {
        skip_all_of(" \t\r\n");
        while (next() == '#') {
            skip_line();
            skip_all_of(" \t\r\n");
        }
    }

    Statement header() {
        Statement statement;
        statement.kind = next_is("[[") ? Statement::Kind::element : Statement::Kind::table;
        skip(statement.kind == Statement::Kind::element ? 2 : 1);
        skip_all_of(blanks);
        statement.keys = keys();
        TomlPath& path = statement.path;
        for (KeyPlace& key : statement.keys) {
            path.emplace_back(key.name);
            key.depth = path.size();
            const bool last = &key == &statement.keys.back();
            if (last && statement.kind == Statement::Kind::element)
                path.emplace_back(elements_[path]++);
            else if (const auto array = elements_.find(path); array != elements_.end() && !last)
                path.emplace_back(array->second - 1);  // within the last element so far
        }
        return statement;
    }

    Statement assignment(const TomlPath& section) {
        Statement statement;
        statement.keys = keys();
        statement.path = section;
        for (KeyPlace& key : statement.keys) {
            statement.path.emplace_back(key.name);
            key.depth = statement.path.size();
        }
        statement.value = assigned_value();
        return statement;
    }

    // The value behind "=".
    ValuePlace assigned_value() {
        skip_all_of(" \t=");
        return value();
    }

    // Dotted key; stands behind it and its blanks afterwards.
    std::vector<KeyPlace> keys() {
        std::vector<KeyPlace> parts;
        while (true) {
            KeyPlace part;
            part.range.begin = at_;
            const bool quoted = next() == '"' || next() == '\'';
            if (quoted)
                skip_string();
            else
                at_ = std::min(text_.find_first_of(" \t.=]\r\n", at_), text_.size());
            part.range.end = at_;
            part.name = text_.substr(part.range.begin, at_ - part.range.begin);
            // The library knows the escapes.
            if (quoted)
                if (const Result<TomlValue> name = parse_toml_value(part.name, {})) part.name = name->text;
            parts.push_back(std::move(part));
            skip_all_of(blanks);
            if (next() != '.') return parts;
            skip(1);
            skip_all_of(blanks);
        }
    }

    void skip_string() {
        const char quote = next();
        const bool escapes = quote == '"';
        const std::string triple(3, quote);
        const std::string end = next_is(triple) ? triple : std::string(1, quote);
        skip(end.size());
        while (!at_end() && !next_is(end)) skip(escapes && next() == '\\' ? 2 : 1);
        skip(end.size());
        // The text of a multi-line string may end in one or two quotes.
        for (int i = 0; i < 2 && end == triple && next() == quote; ++i) skip(1);
    }

    ValuePlace value() {
        ValuePlace place;
        place.range.begin = at_;
        if (next() == '"' || next() == '\'') {
            skip_string();
        } else if (next() == '[') {
            place.kind = ValuePlace::Kind::array;
            read_entries(place, ']');
        } else if (next() == '{') {
            place.kind = ValuePlace::Kind::table;
            read_entries(place, '}');
        } else {
            at_ = std::min(text_.find_first_of(",]}#\r\n", at_), text_.size());
            while (at_ > place.range.begin && blanks.find(text_[at_ - 1]) != std::string_view::npos) --at_;
        }
        place.range.end = at_;
        return place;
    }

    void read_entries(ValuePlace& place, char end) {
        skip(1);
        for (skip_space_and_comments(); !at_end() && next() != end; skip_space_and_comments()) {
            const std::size_t before = at_;
            std::vector<KeyPlace> entry_keys;
            if (place.kind == ValuePlace::Kind::table) entry_keys = keys();
            place.entries.push_back(entry_keys.empty() ? value() : assigned_value());
            place.entries.back().keys = std::move(entry_keys);
            skip_space_and_comments();
            if (next() == ',') skip(1);
            if (at_ == before) break;  // not valid
        }
        skip(1);
    }

    const std::string& text_;
    std::size_t at_ = 0;
    std::map<TomlPath, std::size_t> elements_;  // number of [[headers]] so far
};

}  // namespace

TomlLayout layout_of(const std::string& text) { return LayoutScanner(text).scan(); }

}  // namespace myo::toml
