#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "architecture/module_graph.hpp"

namespace myo::test {

/// The rules of the project's layout as functions from text to broken rules, so that they can be tried on made-up
/// files.

/// One text file of the project: its path from the project's top folder ("core/mesh/weld.cpp") and its content.
struct SourceFile {
    std::string path;
    std::string text;
};

/// A rule that a file breaks: "core/fem/x.hpp:3: why".
using Fault = std::string;

/// Whether a project file of that path exists.
using FileExists = std::function<bool(const std::string& path)>;

struct Include {
    std::string name;
    bool quoted = false;  // "x" rather than <x>
    int line = 0;
};
std::vector<Include> includes_of(const std::string& text);

/// Modules that are not linked, windows and drawing in core, VTK where it does not belong, files that are not
/// there.
std::vector<Fault> include_faults(const ModuleGraph& graph, const SourceFile& file, const FileExists& exists);

/// Printing in core.
std::vector<Fault> printing_faults(const SourceFile& file);

/// More than 400 lines of C++; 500 in tests.
std::vector<Fault> length_faults(const SourceFile& file);

/// Named numbers of core at namespace or function scope, outside policies: `constexpr double most = 3.0;`. Members of a
/// class, arrays and values from std::numeric_limits or std::numbers are no tuning numbers; nor are the sizes, codes
/// and quadrature weights of a few files, which are listed with their reason.
std::vector<Fault> tuning_faults(const SourceFile& file);

/// Policies at namespace scope in core/diagnosis: every phase is given the policy of its DiagnoseSettings, so that a
/// changed number acts everywhere. The layout of the report has its own.
std::vector<Fault> global_policy_faults(const SourceFile& file);

/// Ids of the catalogue of effects (`.id = "soft_patch"`), each with its own file of core/effect.
std::map<std::string, std::string> effect_files(const std::vector<SourceFile>& files);

/// Words in string literals of core, ui and app that are ids of effects, outside the effect's own file: whatever the
/// program knows about a particular effect belongs into its entry of the catalogue.
///
/// @param effects  as from effect_files()
std::vector<Fault> effect_id_faults(const std::map<std::string, std::string>& effects, const SourceFile& file);

/// Paths that exist on one machine only.
std::vector<Fault> machine_path_faults(const SourceFile& file);

/// Folders ("core/mesh") that are no module of CMake.
std::vector<Fault> module_faults(const ModuleGraph& graph, const std::vector<std::string>& folders);

/// Text of C++ with comments and the content of string and character literals blanked; lines stay where they are.
std::string code_only(std::string_view text);

}  // namespace myo::test
