#include "commands/command_knots.hpp"

#include <cassert>

namespace myo::ui::commands {

using Kind = DeclaredCommand::Kind;

fibre::Signal knots_of(const DeclaredCommand* command) {
    if (!command) return fibre::Signal::constant(0.0);
    assert(command->kind != Kind::file);
    if (command->kind == Kind::curve) return command->curve;
    return command->kind == Kind::step ? fibre::Signal::step(0.0, 0.0, command->value)
                                       : fibre::Signal::constant(command->value);
}

DeclaredCommand command_of(const fibre::Signal& knots) {
    const double value = knots.value(0.0);
    if (knots.times_s.size() == 1) return {Kind::constant, value};
    if (knots == fibre::Signal::step(0.0, 0.0, value)) return {Kind::step, value};
    return {Kind::curve, value, knots};
}

}  // namespace myo::ui::commands
