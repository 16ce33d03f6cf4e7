#include "commands/sought_signals.hpp"

#include <algorithm>

namespace myo::ui::commands {

std::vector<SignalChoice> signal_choices(const Scene& scene, const Settings& settings) {
    const DeclaredParts& declared = scene.declared;
    std::vector<SignalChoice> choices;
    const auto add = [&](const std::string& name, const char* table, std::size_t index) {
        choices.push_back({name, declared.kept.count(name) == 0, {table, index}});
    };
    for (const Muscle& muscle : settings.muscles) {
        if (!muscle.follows.empty()) continue;
        const auto own = std::find(declared.muscles.begin(), declared.muscles.end(), muscle.declared);
        // A declared muscle may have another name in the window than in its table.
        if (own == declared.muscles.end())
            choices.push_back({muscle.name, muscle.sought, {}});
        else
            choices.push_back({muscle.name,
                               declared.kept.count(*own) == 0,
                               {"muscle", static_cast<std::size_t>(own - declared.muscles.begin())}});
    }
    for (std::size_t c = 0; c < declared.chambers.size(); ++c) add(declared.chambers[c], "chamber", c);
    for (std::size_t t = 0; t < declared.tendons.size(); ++t) add(declared.tendons[t].name, "tendon", t);
    return choices;
}

bool seeks_any_signal(const Scene& scene, const Settings& settings) {
    const std::vector<SignalChoice> choices = signal_choices(scene, settings);
    return std::any_of(choices.begin(), choices.end(), [](const SignalChoice& choice) { return choice.sought; });
}

}  // namespace myo::ui::commands
