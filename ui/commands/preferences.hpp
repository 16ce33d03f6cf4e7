#pragma once

#include <filesystem>
#include <vector>

#include "commands/step_cost.hpp"
#include "platform/theme.hpp"

namespace myo::ui::commands {

/// Sizes of the window's parts that a person has dragged, in units of the UI scale.
struct LayoutSizes {
    float rail = 336.0f;
    float strip = 288.0f;

    bool operator==(const LayoutSizes&) const = default;
};

/// What is kept from one start of the program to the next.
struct Preferences {
    platform::ThemeName theme = platform::ThemeName::dark;
    float scale = 0.0f;  // of text and controls; 0: as the screen asks for
    LayoutSizes layout;
    std::vector<std::filesystem::path> recent;     // experiments, meshes and projects, the newest first
    std::vector<std::filesystem::path> bookmarks;  // folders of the file browser
    std::vector<StepCost> step_costs;              // of runs on this machine, the newest last

    bool operator==(const Preferences&) const = default;
};

inline constexpr std::size_t most_recent = 10;
inline constexpr float least_scale = 0.75f, greatest_scale = 2.5f;

}  // namespace myo::ui::commands
