#pragma once

#include <string>
#include <vector>

#include "commands/backend.hpp"

// Whose signals Optimise seeks.

namespace myo::ui::commands {

/// A muscle that follows none, a chamber or a tendon.
struct SignalChoice {
    std::string name;
    bool sought = true;
    toml::TomlPath declared;  // its table in the declaration; empty: a muscle that was made in the window
};

/// All of them: muscles of the settings, then chambers and tendons.
std::vector<SignalChoice> signal_choices(const Scene& scene, const Settings& settings);

/// Whether the signal of any is sought.
bool seeks_any_signal(const Scene& scene, const Settings& settings);

}  // namespace myo::ui::commands
