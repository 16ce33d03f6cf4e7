#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "effect/effect_declaration.hpp"

namespace myo::experiment {

/// Reads a file of schema law/1: a law of one's own, which becomes an entry beside those of the effect catalogue.
///
/// Errors: unreadable file, unknown or missing key, a name or unit without meaning, an error in an expression, with
/// file, line and column.
Result<effect::LawPointer> read_law_file(const std::filesystem::path& path);

/// Reads the text of such a file.
///
/// @param name  stands in locations in place of the path
Result<effect::LawPointer> read_law_text(const std::string& text, const std::string& name);

}  // namespace myo::experiment
