#include "commands/seek_choice.hpp"

namespace myo::ui::commands {

std::vector<SeekChoice> seek_choices(const std::vector<SeekChoice>& declared, const Settings& settings) {
    std::vector<SeekChoice> choices;
    for (const Muscle& muscle : settings.muscles) {
        if (muscle.paint) {
            choices.push_back({"direction:" + muscle.name, "Fibre direction of " + muscle.name, muscle.declared});
            choices.push_back({"weights:" + muscle.name, "Painted weights of " + muscle.name, muscle.declared});
            continue;
        }
        // Under the name that the muscle has now.
        for (const SeekChoice& choice : declared)
            if (!choice.muscle.empty() && choice.muscle == muscle.declared)
                // The words end with the name in the experiment, which is replaced by the present one.
                choices.push_back({choice.word.substr(0, choice.word.find(':') + 1) + muscle.name,
                                   choice.label.substr(0, choice.label.size() - muscle.declared.size()) + muscle.name,
                                   muscle.declared});
    }
    for (const SeekChoice& choice : declared)
        if (choice.muscle.empty()) choices.push_back(choice);
    return choices;
}

}  // namespace myo::ui::commands
