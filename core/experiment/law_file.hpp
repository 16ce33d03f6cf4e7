#pragma once

#include <filesystem>

#include "base/result.hpp"
#include "effect/effect_declaration.hpp"

namespace myo::experiment {

/// Reads a file of schema law/1: a law of the user, which becomes an effect in addition to those of the catalogue. Keys
/// and expressions: manual, laws.md.
///
/// Errors: unreadable file, unknown or missing key, a name or unit without meaning, an error in an expression, with
/// file, line and column.
Result<effect::LawPointer> read_law_file(const std::filesystem::path& path);

/// Reads the text of such a file.
///
/// @param name  stands in locations in place of the path
/// Errors: those of read_law_file(), but for an unreadable file.
Result<effect::LawPointer> read_law_text(const std::string& text, const std::string& name);

}  // namespace myo::experiment
