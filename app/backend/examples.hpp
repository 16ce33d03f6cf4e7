#pragma once

#include <vector>

#include "commands/backend.hpp"

namespace myo::backend {

/// Bundled examples, from the source tree or the installation; empty if neither is found.
std::vector<ui::commands::Example> bundled_examples();

}  // namespace myo::backend
