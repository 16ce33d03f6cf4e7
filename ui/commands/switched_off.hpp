#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "commands/declaration.hpp"
#include "effect/effect_declaration.hpp"

namespace myo::ui::commands {

/// A declared effect that runs leave out. With its id, an entry whose place holds another effect by now is ignored.
struct SwitchedOff {
    std::size_t index = 0;  // in the order of the declaration
    std::string id;         // of the effect

    bool operator==(const SwitchedOff&) const = default;
};

/// Whether the list names this effect of the declaration.
bool is_off(const std::vector<SwitchedOff>& off, const std::vector<effect::EffectDeclaration>& declared,
            std::size_t index);

/// Switches a declared effect.
std::vector<SwitchedOff> switched(std::vector<SwitchedOff> off, const SwitchedOff& effect, bool is_on);

/// The list after edits of the declaration: effects behind a removed one move up.
std::vector<SwitchedOff> moved_by(std::vector<SwitchedOff> off, const std::vector<DeclarationEdit>& edits);

/// The declared effects without those that are switched off.
std::vector<effect::EffectDeclaration> effects_on(const std::vector<effect::EffectDeclaration>& declared,
                                                  const std::vector<SwitchedOff>& off);

}  // namespace myo::ui::commands
