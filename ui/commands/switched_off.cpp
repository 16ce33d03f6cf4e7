#include "commands/switched_off.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace myo::ui::commands {
namespace {

/// Index of an effect that an edit removes whole; empty: it does something else.
std::optional<std::size_t> removed_effect(const DeclarationEdit& edit) {
    const auto* const removed = std::get_if<RemoveDeclared>(&edit);
    if (!removed || removed->path.size() != 2) return std::nullopt;
    const auto* const table = std::get_if<std::string>(&removed->path[0]);
    const auto* const index = std::get_if<std::size_t>(&removed->path[1]);
    if (!table || *table != "effect" || !index) return std::nullopt;
    return *index;
}

}  // namespace

bool is_off(const std::vector<SwitchedOff>& off, const std::vector<effect::EffectDeclaration>& declared,
            std::size_t index) {
    return index < declared.size() &&
           std::find(off.begin(), off.end(), SwitchedOff{index, declared[index].id}) != off.end();
}

std::vector<SwitchedOff> switched(std::vector<SwitchedOff> off, const SwitchedOff& effect, bool is_on) {
    std::erase_if(off, [&](const SwitchedOff& other) { return other.index == effect.index; });
    if (!is_on) off.push_back(effect);
    // Sorted, so that the order of clicks makes no difference between settings.
    std::sort(off.begin(), off.end(), [](const SwitchedOff& a, const SwitchedOff& b) { return a.index < b.index; });
    return off;
}

std::vector<SwitchedOff> moved_by(std::vector<SwitchedOff> off, const std::vector<DeclarationEdit>& edits) {
    for (const DeclarationEdit& edit : edits) {
        const std::optional<std::size_t> removed = removed_effect(edit);
        if (!removed) continue;
        std::erase_if(off, [&](const SwitchedOff& effect) { return effect.index == *removed; });
        for (SwitchedOff& effect : off)
            if (effect.index > *removed) --effect.index;
    }
    return off;
}

std::vector<effect::EffectDeclaration> effects_on(const std::vector<effect::EffectDeclaration>& declared,
                                                  const std::vector<SwitchedOff>& off) {
    std::vector<effect::EffectDeclaration> on;
    for (std::size_t i = 0; i < declared.size(); ++i)
        if (!is_off(off, declared, i)) on.push_back(declared[i]);
    return on;
}

}  // namespace myo::ui::commands
