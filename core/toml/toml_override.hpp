#pragma once

#include <string>

#include "base/result.hpp"
#include "toml/toml_value.hpp"

namespace myo::toml {

/// Sets one value of a document from the command line, as if it stood in the file. Its location becomes "--set".
///
/// @param key    as path_of_key() takes it; missing tables are created, an index one past the end appends an element
/// @param value  in TOML syntax, or a bare word
/// Errors: malformed key or value, missing element. Whether the key is known is checked later, by the reader.
Result<void> override_toml(TomlValue& document, const std::string& key, const std::string& value);

}  // namespace myo::toml
