#pragma once

#include <filesystem>
#include <string>

#include "base/result.hpp"

namespace myo::experiment {

/// Text of an experiment.toml as it must read in another folder: names of files that it holds are made relative to
/// `folder`; everything else stays. Absolute names stay absolute. No file is copied and none needs to exist.
///
/// Errors: `written` cannot be read.
Result<std::string> experiment_text_for(const std::filesystem::path& folder, const std::filesystem::path& written);
/// A text of an experiment.toml, which need not be that of a file, as it must read in another folder.
///
/// @param home  folder against which the names in `text` are resolved
std::string experiment_text_for(const std::filesystem::path& folder, const std::string& text,
                                const std::filesystem::path& home);

}  // namespace myo::experiment
