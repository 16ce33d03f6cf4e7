#pragma once

#include <filesystem>
#include <vector>

#include "base/result.hpp"
#include "commands/preferences.hpp"

// What belongs to the person and not to a project: preferences, and unsaved work that is kept for recovery.

namespace myo::backend {

/// Where preferences lie: $XDG_CONFIG_HOME/myoloop/preferences.toml, else below ~/.config. Empty when neither is known.
std::filesystem::path preferences_file();

/// A missing file gives the defaults. Errors: those of TOML, unknown keys, values out of range.
Result<ui::commands::Preferences> read_preferences(const std::filesystem::path& file);
Result<void> write_preferences(const std::filesystem::path& file, const ui::commands::Preferences& preferences);

/// Where this process keeps its unsaved work: in $XDG_STATE_HOME/myoloop, else below ~/.local/state. Empty when neither
/// is known.
std::filesystem::path recovery_file();

/// Unsaved work of processes that are gone, the oldest first.
std::vector<std::filesystem::path> found_recoveries(const std::filesystem::path& folder);

}  // namespace myo::backend
