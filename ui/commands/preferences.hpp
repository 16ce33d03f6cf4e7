#pragma once

#include <filesystem>
#include <vector>

#include "commands/step_cost.hpp"
#include "platform/theme.hpp"

namespace myo::ui::commands {

/// Sizes of the window's parts that the user can change by dragging their edges [pixels at scale 1].
struct LayoutSizes {
    float rail = 336.0f;   // width of the side panel
    float strip = 288.0f;  // height of the panels below the view

    bool operator==(const LayoutSizes&) const = default;
};

/// Settings of the program that are kept between sessions, independent of any project.
struct Preferences {
    platform::ThemeName theme = platform::ThemeName::dark;
    float scale = 0.0f;  // of text and controls; 0: as the screen suggests
    LayoutSizes layout;
    std::vector<std::filesystem::path> recent;     // opened experiments, meshes and projects, newest first
    std::vector<std::filesystem::path> bookmarks;  // folders of the file browser
    std::vector<StepCost> step_costs;              // of runs on this machine, newest last

    bool operator==(const Preferences&) const = default;
};

// Limits of the list of recent files and of the scale.
inline constexpr std::size_t max_recent = 10;
inline constexpr float min_scale = 0.75f, greatest_scale = 2.5f;

}  // namespace myo::ui::commands
