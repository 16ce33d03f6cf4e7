#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "effect/effect.hpp"

namespace myo::diagnosis {

/// `[[effect]]` tables of experiment.toml.
std::string effect_tables(const std::vector<effect::EffectDeclaration>& effects, bool calibrate);

/// The text of an experiment.toml that declares these effects besides what the person wrote in `written`; the files it
/// names are given as seen from `folder`. What was set on the command line is not in it. Errors: `written` cannot be
/// read.
Result<std::string> augmented_experiment(const std::filesystem::path& written,
                                         const std::vector<effect::EffectDeclaration>& effects,
                                         const std::filesystem::path& folder);

}  // namespace myo::diagnosis
