#pragma once

#include <string>

#include "base/result.hpp"
#include "toml/toml_value.hpp"

namespace myo::toml {

/// Sets one value of a document from the command line, as if the file said so; its place becomes "--set".
///
/// @param key    "material.density_kg_m3", "trial[0].start_s", or an element of an array of tables by its name or id:
///               "trial.gravity_release.start"; a part with dots stands in double quotes. Missing tables are made;
///               an index one past the end appends.
/// @param value  in TOML syntax, or a bare word
/// Errors: malformed key or value, no such element. Whether the key is known is the reader's question.
Result<void> override_toml(TomlValue& document, const std::string& key, const std::string& value);

}  // namespace myo::toml
