#pragma once

#include <memory>

#include "commands/backend.hpp"

namespace myo::backend {

/// Backend of the workbench that computes with the core.
///
/// See ui/commands/backend.hpp for the contract of each method. The backend has no state of its own: scenes, meshes and
/// runs carry what it needs.
///
/// A mesh file without experiment gets a default set-up and can be run at once: clamped at the lower end of its longest
/// axis and released under gravity.
std::shared_ptr<ui::commands::Backend> make_core_backend();

}  // namespace myo::backend
