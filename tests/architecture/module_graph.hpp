#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace myo::test {

/// One module as CMake declares it.
struct Module {
    std::string name;
    std::string folder;             // "core", "ui" or "app"
    std::set<std::string> links;    // modules that it links itself
    std::set<std::string> reaches;  // all modules that it may include: itself, its links and theirs
};

/// Modules by name. The files of `app/` itself, the program, are the module "app".
using ModuleGraph = std::map<std::string, Module>;

/// Reads the calls `myoloop_module(...)` and `target_link_libraries(myoloop_... )` of CMake files.
ModuleGraph read_module_graph(const std::vector<std::string>& cmake_files);

/// The module of a file of core, ui or app ("core/mesh/weld.cpp" -> "mesh"); null where CMake declares none.
const Module* module_of(const ModuleGraph& graph, const std::string& path);

/// Modules that reach themselves through others.
std::vector<std::string> cycles(const ModuleGraph& graph);

}  // namespace myo::test
