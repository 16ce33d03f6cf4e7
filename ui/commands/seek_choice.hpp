#pragma once

#include <string>
#include <vector>

#include "commands/settings.hpp"

// What Optimise may change in addition to the signals of the actuators.

namespace myo::ui::commands {

/// A quantity of the body that Optimise can seek.
struct SeekChoice {
    std::string word;         // in OptimizeRequest::seek: "direction:left"
    std::string label;        // "Fibre direction of left"
    std::string muscle = {};  // name in the experiment of the muscle that it belongs to; empty: of a part or the body
};

/// Choices for the muscles of the settings, then those of parts and body. A painted muscle has all of its own,
/// whatever it was declared as.
///
/// @param declared  of the experiment
std::vector<SeekChoice> seek_choices(const std::vector<SeekChoice>& declared, const Settings& settings);

}  // namespace myo::ui::commands
