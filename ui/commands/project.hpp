#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "commands/settings.hpp"
#include "commands/view_options.hpp"

namespace myo::ui::commands {

/// What a project file holds: on which experiment or mesh it stands, and all that was set, painted and drawn on it.
struct Project {
    std::filesystem::path source;           // experiment folder, its experiment.toml, or a mesh file; absolute
    std::optional<double> metres_per_unit;  // of a mesh file without unit
    Settings settings;
    ViewOptions view;
    std::string trial;                       // that was shown; empty: the first
    std::vector<std::string> warnings = {};  // of reading it: what it names and is not there

    bool operator==(const Project&) const = default;
};

inline constexpr const char* project_ending = ".myoloop";
inline bool is_project(const std::filesystem::path& path) { return path.extension() == project_ending; }

}  // namespace myo::ui::commands
