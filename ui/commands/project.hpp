#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "commands/settings.hpp"
#include "commands/view_options.hpp"

namespace myo::ui::commands {

/// Content of a project file: the experiment or mesh it refers to, and everything set and painted on it.
struct Project {
    std::filesystem::path source;           // experiment folder, its experiment.toml, or a mesh file; absolute path
    std::optional<double> metres_per_unit;  // length unit of a mesh file without unit
    Settings settings;
    ViewOptions view;
    std::string trial;                       // shown trial; empty: the first
    bool self_contained = false;             // `source` is a copy in the project's own folder `<name>.files`
    bool source_missing = false;             // nothing is at `source`
    std::filesystem::path copy_of = {};      // of unsaved work: the project's own file; empty: it has none
    std::vector<std::string> warnings = {};  // from reading: names that the experiment no longer has

    bool operator==(const Project&) const = default;
};

// File name extension of projects.
inline constexpr const char* project_ending = ".myoloop";
/// Whether a path ends like a project. The file need not exist.
inline bool is_project(const std::filesystem::path& path) { return path.extension() == project_ending; }

}  // namespace myo::ui::commands
