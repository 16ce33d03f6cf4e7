#pragma once

#include "commands/declared_parts.hpp"

// Commands of chambers and tendons as the knots of a curve, and back.

namespace myo::ui::commands {

/// Knots of a command [SI]: one of a constant, a jump at t = 0 of a step, the rows of a curve; of none one at zero. A
/// file has knots that are not declared, so it must not be asked for.
///
/// @param command  null: none
fibre::Signal knots_of(const DeclaredCommand* command);

/// Shortest command with these knots: a single one is a constant, a jump from zero at t = 0 a step.
DeclaredCommand command_of(const fibre::Signal& knots);

}  // namespace myo::ui::commands
