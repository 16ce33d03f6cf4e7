#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "effect/catalogue.hpp"
#include "exit_status.hpp"
#include "standard_output.hpp"

namespace myo::app {

std::function<int()> declare_effects(CLI::App&) {
    // Id, kind and summary in a line, parameters below; the 13 columns are those of the kind and its blanks.
    return [] {
        std::size_t width = 0;
        for (const effect::Effect& effect : effect::effect_catalogue()) width = std::max(width, effect.id.size());
        for (const effect::Effect& effect : effect::effect_catalogue()) {
            std::string parameters;
            for (const effect::EffectParameterEntry& p : effect.parameters)
                parameters += (parameters.empty() ? "" : ", ") + p.name + (p.optional ? " (optional)" : "");
            print_format("%-*s  %-11s  %s\n%*s  %s\n", static_cast<int>(width), effect.id.c_str(),
                         to_string(effect.kind).c_str(), effect.summary.c_str(), static_cast<int>(width) + 13, "",
                         parameters.c_str());
        }
        return static_cast<int>(status_done);
    };
}

}  // namespace myo::app
