#pragma once

#include <filesystem>
#include <string>

#include "base/result.hpp"

namespace myo::experiment {

/// Text of an experiment.toml as it must read in another folder: names of files that it holds are made relative to
/// `folder`; everything else stays.
///
/// Errors: `written` cannot be read.
Result<std::string> experiment_text_for(const std::filesystem::path& folder, const std::filesystem::path& written);
/// The same for a text that need not be the one of the file.
///
/// @param home  folder against which the names in `text` are resolved
std::string experiment_text_for(const std::filesystem::path& folder, const std::string& text,
                                const std::filesystem::path& home);

}  // namespace myo::experiment
