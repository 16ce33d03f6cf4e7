#pragma once

#include <string>

#include "base/result.hpp"
#include "toml/toml_path.hpp"

namespace myo::toml {

// Edits of the text of a TOML file. Comments, order, blank lines, line ends and the formatting of everything else stay.
//
// Common errors of all edits: the document is not valid TOML ("line 12"); the edit would change anything but the
// addressed place, which is checked by reading the result.

/// Sets a value.
///
/// An existing value is replaced in place; the comment behind it stays. A missing key is added at the end of its table,
/// before the blank lines and comments that precede the next header. A missing table is added at the end of the file,
/// or behind its parent table. Keys of inline tables and dotted keys are set or added where they stand. An index one
/// past the end appends an element.
///
/// @param value  one value in TOML syntax, as made by toml_number(), toml_text(), toml_list()
/// Errors: malformed value; missing element; the place is a table with lines of its own.
Result<std::string> with_value(const std::string& document, const TomlPath& path, const std::string& value);

/// Removes a key with the comment on its line, a table with its keys, subtables and the comment lines directly above
/// its header, an element of an array of tables with all its subtables, or an element of an array.
///
/// @return  the document itself if the place does not exist
Result<std::string> without(const std::string& document, const TomlPath& path);

/// Appends an element to an array of tables, behind the last element and everything that belongs to it. The first
/// element of an array stands at the end of the file, or of the table it belongs to.
///
/// @param array  "trial", or {"trial", 2, "load"}
/// @param body   lines "key = value"; subtables may follow, with full headers
/// Errors: the array is written in brackets; missing element on the path; the body is not valid.
Result<std::string> with_appended_table(const std::string& document, const TomlPath& array, const std::string& body);

/// Copies an element of an array of tables, with its subtables and comments, behind itself.
///
/// Errors: not an element with a header of its own.
Result<std::string> with_duplicated_table(const std::string& document, const TomlPath& element);

/// Renames a key of a table in place, in all headers that contain it.
///
/// @param path  to the value under its present key
/// Errors: no such key; the table has the new key already.
Result<std::string> with_renamed_key(const std::string& document, const TomlPath& path, const std::string& key);

}  // namespace myo::toml
