#pragma once

#include <memory>

#include "commands/backend.hpp"

namespace myo::backend {

/// The workbench's work, done by the core.
///
/// A mesh file without an experiment gets a plain set-up, so that it can be run at once: held at the lower end of its
/// longest axis and released under gravity.
std::shared_ptr<ui::commands::Backend> make_core_backend();

}  // namespace myo::backend
