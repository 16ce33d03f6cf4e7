#pragma once

#include "commands/declared_parts.hpp"
#include "setup/setup.hpp"

namespace myo::backend {

/// Chambers, tendons, cavities and commands of an experiment as declared, for the panels that edit them. SI units;
/// commands per trial in the order of declaration.
ui::commands::DeclaredParts declared_parts(const setup::Setup& setup);

}  // namespace myo::backend
