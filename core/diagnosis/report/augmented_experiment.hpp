#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "effect/effect.hpp"

namespace myo::diagnosis {

/// Effects as `[[effect]]` tables of experiment.toml.
/// Numbers have eight digits.
/// @param calibrate  fits determine the parameters, with these values as start
std::string effect_tables(const std::vector<effect::EffectDeclaration>& effects, bool calibrate);

/// Text of an experiment.toml with these effects in addition to what the user wrote in `written`. Its file names are
/// relative to `folder`. Settings of the command line are not included. Errors: `written` cannot be read.
Result<std::string> augmented_experiment(const std::filesystem::path& written,
                                         const std::vector<effect::EffectDeclaration>& effects,
                                         const std::filesystem::path& folder);

}  // namespace myo::diagnosis
