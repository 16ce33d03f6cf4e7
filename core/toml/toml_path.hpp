#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "base/result.hpp"
#include "toml/toml_value.hpp"

namespace myo::toml {

/// Step into a document: a key of a table, or the index of an element of an array (of tables or of values).
using TomlStep = std::variant<std::string, std::size_t>;
/// Steps from the document to one of its values.
using TomlPath = std::vector<TomlStep>;

/// Path for messages: "trial[1].load[0].force_N".
std::string path_text(const TomlPath& path);
/// An element of an array for messages: "trial[1]".
std::string element_text(const std::string& array, std::size_t index);

/// True if the path leads to the place `prefix` or into it.
bool starts_with(const TomlPath& path, const TomlPath& prefix);
/// Number of steps that both paths have in common at their beginning.
std::size_t common_steps(const TomlPath& a, const TomlPath& b);
/// The first `count` steps.
TomlPath first_steps(const TomlPath& path, std::size_t count);

/// Value at a path; null if absent.
TomlValue* find_at(TomlValue& document, const TomlPath& path);
/// find_at() in a constant document.
const TomlValue* find_at(const TomlValue& document, const TomlPath& path);

/// Sets a value. Missing tables and arrays are created; an index one past the end appends an element.
/// Errors: a step into a value that is no table or array, an element that is missing.
Result<void> set_at(TomlValue& document, const TomlPath& path, const TomlValue& value);
/// Removes a value if it is there.
void remove_at(TomlValue& document, const TomlPath& path);

}  // namespace myo::toml
