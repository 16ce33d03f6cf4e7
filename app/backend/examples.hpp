#pragma once

#include <vector>

#include "commands/backend.hpp"

namespace myo::backend {

/// Bundled examples with their pictures, those with the most trials first, from the source tree or the installation;
/// empty if neither is found. Folders whose experiment cannot be read are left out. Reads all bodies: slow, so callers
/// keep the result.
std::vector<ui::commands::Example> bundled_examples();

}  // namespace myo::backend
