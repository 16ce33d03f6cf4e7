#pragma once

#include <string>

#include "base/result.hpp"

namespace myo::backend {

/// Renames a marker or probe in the text of experiment.toml, in effects, columns, goals and repairs too. Recordings
/// keep their label.
///
/// @param name, wanted  present and new name; markers on the mount (`fixed_m`) are not renamed
/// Errors: no marker or probe of that name; the new name is taken; the text is no TOML.
Result<std::string> with_renamed_marker(const std::string& text, const std::string& name, const std::string& wanted);

}  // namespace myo::backend
