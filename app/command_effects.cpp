#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "exit_status.hpp"
#include "project/effect_vocabulary.hpp"

namespace myo {

std::function<int()> declare_effects(CLI::App&) {
    return [] {
        std::size_t width = 0;
        for (const EffectEntry& effect : effect_vocabulary()) width = std::max(width, effect.id.size());
        for (const EffectEntry& effect : effect_vocabulary()) {
            std::string parameters;
            for (const EffectParameterEntry& p : effect.parameters)
                parameters += (parameters.empty() ? "" : ", ") + p.name + (p.optional ? " (optional)" : "");
            std::printf("%-*s  %s\n", static_cast<int>(width), effect.id.c_str(), parameters.c_str());
        }
        std::puts("\nThis version reads these names in experiment.toml and checks their parameters; it does not simulate the effects yet.");
        return static_cast<int>(status_done);
    };
}

}  // namespace myo
