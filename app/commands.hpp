#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace myo::app {

/// A subcommand: a file command_<name>.cpp and a line in commands.cpp.
struct Subcommand {
    std::string name;
    std::string summary;
    /// Adds the command's options and returns what it does; that returns the exit status.
    std::function<int()> (*declare)(CLI::App& app);
    std::string former_name = {};  // still understood, with a note; empty: none
};
const std::vector<Subcommand>& commands();
std::vector<std::string> command_names();

std::function<int()> declare_simulate(CLI::App& app);
std::function<int()> declare_diagnose(CLI::App& app);
std::function<int()> declare_validate(CLI::App& app);
std::function<int()> declare_calibrate(CLI::App& app);
std::function<int()> declare_optimize(CLI::App& app);
std::function<int()> declare_gradcheck(CLI::App& app);
std::function<int()> declare_mesh(CLI::App& app);
std::function<int()> declare_screenshot(CLI::App& app);
std::function<int()> declare_reproduce(CLI::App& app);
std::function<int()> declare_bench(CLI::App& app);
std::function<int()> declare_frames(CLI::App& app);
std::function<int()> declare_effects(CLI::App& app);
std::function<int()> declare_info(CLI::App& app);

/// As it was called, for the records.
const std::vector<std::string>& command_line();
void remember_command_line(int argc, const char* const* argv);

}  // namespace myo::app
