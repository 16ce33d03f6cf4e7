#pragma once

#include <filesystem>
#include <vector>

#include "base/result.hpp"
#include "commands/preferences.hpp"

// Files of the user that belong to no project: preferences, and unsaved work kept for recovery.

namespace myo::backend {

/// Path of the preferences: $XDG_CONFIG_HOME/myoloop/preferences.toml, else below ~/.config; empty if neither is known.
std::filesystem::path preferences_file();

/// Reads preferences; a missing file gives the defaults. Errors: those of TOML, unknown keys, values out of range.
Result<ui::commands::Preferences> read_preferences(const std::filesystem::path& file);
/// Writes preferences. Errors: the file cannot be written.
Result<void> write_preferences(const std::filesystem::path& file, const ui::commands::Preferences& preferences);

/// Path for the unsaved work of this process: in $XDG_STATE_HOME/myoloop, else below ~/.local/state; empty if neither
/// is known.
std::filesystem::path recovery_file();

/// Name and local time of unsaved work: "finger.myoloop, 29 Nov 2026, 14:05"; the experiment's name if it was never
/// saved, "without a name" if the file cannot be read.
std::string unsaved_work_words(const std::filesystem::path& file);

/// Unsaved work that no window of Myoloop writes to, oldest first; none if the folder does not exist.
std::vector<std::filesystem::path> found_recoveries(const std::filesystem::path& folder);

}  // namespace myo::backend
