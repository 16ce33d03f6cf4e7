#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "toml/toml_layout.hpp"
#include "toml/toml_lines.hpp"
#include "toml/toml_path.hpp"

namespace myo::toml {

// What all edits of a document share.

/// A document as values and as text with places.
struct EditedDocument {
    std::string text;
    TomlValue values;
    TomlLayout layout;
};

/// Errors: not valid TOML, with line.
Result<EditedDocument> open_document(const std::string& text);

/// The result of an edit, if it has the expected values.
///
/// @param expected  the document's values after the edit
/// @param path      of the edit; tables and arrays on it may vanish when they become empty
/// Errors: the text is not valid TOML or has other values.
Result<std::string> checked(const std::string& text, TomlValue expected, const TomlPath& path);

/// The assignment at a path, or at a beginning of it: `follows = { ratio = -1.0 }` for "follows.ratio".
const Statement* assignment_of(const TomlLayout& layout, const TomlPath& path);

/// The last statement at or below a path.
std::optional<std::size_t> last_statement_of(const TomlLayout& layout, const TomlPath& path);
/// The first statement at or below a path.
std::optional<std::size_t> first_statement_of(const TomlLayout& layout, const TomlPath& path);

/// Last statement of the section that holds a statement.
std::size_t last_of_section(const TomlLayout& layout, std::size_t statement);

/// Number of steps of a path that headers contain.
std::size_t steps_in_headers(const TomlLayout& layout, const TomlPath& path);

/// Header and lines of a new table as an insertion behind its parent or the elements before it.
///
/// @param path   of the table, or of the element of an array of tables
/// @param lines  below the header; they end in "\n"
Replacement inserted_table(const EditedDocument& document, const TomlPath& path, const std::string& lines);

/// Header of a table, "[markers.rest_m]", or of an element, "[[trial.load]]".
std::string header_text(const TomlPath& path);

}  // namespace myo::toml
