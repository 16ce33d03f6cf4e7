#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "toml/toml_path.hpp"

namespace myo::toml {

/// Bytes [begin, end) of a text.
struct TextRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// One part of a key "trial.load".
struct KeyPlace {
    std::string name;       // without quotes and escapes
    TextRange range;        // with quotes
    std::size_t depth = 0;  // steps of the statement's path up to this part; 0 within a value
};

/// Where a value stands, with the entries of an array or an inline table.
struct ValuePlace {
    enum class Kind { plain, array, table };

    Kind kind = Kind::plain;
    TextRange range;                  // all lines of a value, without comment behind it
    std::vector<KeyPlace> keys;       // key of an entry of an inline table; several parts if dotted
    std::vector<ValuePlace> entries;  // in the order of the text

    /// First byte, that of its key if it has one.
    std::size_t begin() const { return keys.empty() ? range.begin : keys.front().range.begin; }
};

/// A header or an assignment: whole lines.
struct Statement {
    enum class Kind { assignment, table, element };  // key = value, [key], [[key]]

    Kind kind = Kind::assignment;
    TomlPath path;               // place in the document, with the index of each element of an array of tables
    std::vector<KeyPlace> keys;  // several parts if dotted
    ValuePlace value;            // only for kind assignment
    TextRange lines;             // with indentation, comment behind it and line end

    bool is_header() const { return kind != Kind::assignment; }
    /// Path of the table in whose section an assignment stands.
    TomlPath section() const { return first_steps(path, path.size() - keys.size()); }
};

/// The statements of a document. What stands between them are blank lines and comments.
///
/// The TOML library has the positions of values only, in code points. Edits also need headers, commas and comments.
struct TomlLayout {
    std::vector<Statement> statements;  // in the order of the text
    std::size_t begin = 0;              // first byte behind a byte order mark
};

/// Layout of a text that parse_toml() accepts. The layout of any other text is unspecified.
TomlLayout layout_of(const std::string& text);

}  // namespace myo::toml
