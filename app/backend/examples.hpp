#pragma once

#include <vector>

#include "commands/backend.hpp"

namespace myo::backend {

/// The bundled examples: beside the program's sources, or where it was installed. Empty when they are in neither place.
std::vector<ui::commands::Example> bundled_examples();

}  // namespace myo::backend
