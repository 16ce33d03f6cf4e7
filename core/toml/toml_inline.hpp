#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "toml/toml_lines.hpp"

namespace myo::toml {

// Edits within a value: entries of arrays and inline tables. All return replacements for the text of the document.

/// Sets the value at a path that starts with the path of the assignment.
/// Errors: the place cannot hold a value.
Result<Replacement> set_inline(const std::string& text, const Statement& assignment, const TomlPath& path,
                               const std::string& value);

/// Ranges to be removed for the entry at a path. Several for a table of dotted keys; none if it is not there.
/// Only the last range may be removed: the others are then found anew, as their commas may have changed.
std::vector<TextRange> inline_removals(const std::string& text, const Statement& assignment, const TomlPath& path);

/// Keys of inline tables that a path names.
std::vector<KeyPlace> inline_keys(const Statement& assignment, const TomlPath& path);

}  // namespace myo::toml
