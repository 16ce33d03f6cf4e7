#pragma once

#include <string>

#include "base/result.hpp"
#include "toml/toml_path.hpp"

namespace myo::toml {

/// Place of a key as people write it: "material.density_kg_m3", "trial[0].start_s", or an element of an array of tables
/// by its name or id: "trial.gravity_release.start". A part that contains dots is quoted with double quotes.
///
/// @param document  names are looked up in it; keys that it lacks are taken as new ones, an index one past the end as
///                  an appended element
/// Errors, without location: malformed key, missing element.
Result<TomlPath> path_of_key(const TomlValue& document, const std::string& key);

}  // namespace myo::toml
