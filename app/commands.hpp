#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace myo::app {

/// A subcommand of the program: a file command_<name>.cpp, a declaration below and an entry in commands.cpp.
struct Subcommand {
    std::string name;
    std::string summary;  // one line of the help
    /// Adds the options of the command to `app` and returns the action to run after parsing, which returns the exit
    /// status.
    std::function<int()> (*declare)(CLI::App& app);
    std::string former_name = {};  // still accepted, with a note; empty: none
};
/// All subcommands, in the order of the help.
const std::vector<Subcommand>& commands();
/// Names of all subcommands.
std::vector<std::string> command_names();

// One declaration per file command_<name>.cpp; see Subcommand::declare.

/// Simulates the trials of an experiment with its declared model.
std::function<int()> declare_simulate(CLI::App& app);
/// Finds the effect that the declared model lacks.
std::function<int()> declare_diagnose(CLI::App& app);
/// Lists which effects of which size an experiment could reveal.
std::function<int()> declare_power(CLI::App& app);
/// Proposes the trial that best separates two sets of effects.
std::function<int()> declare_propose(CLI::App& app);
/// Validates diagnosis or defaults on synthetic experiments.
std::function<int()> declare_validate(CLI::App& app);
/// Runs a command on many variants of an experiment.
std::function<int()> declare_sweep(CLI::App& app);
/// Fits the declared unknowns.
std::function<int()> declare_calibrate(CLI::App& app);
/// Finds the actuation that follows a recorded motion.
std::function<int()> declare_optimize(CLI::App& app);
/// Compares the adjoint gradient with finite differences.
std::function<int()> declare_gradcheck(CLI::App& app);
/// Meshes a surface or checks a volume mesh.
std::function<int()> declare_mesh(CLI::App& app);
/// Draws the workbench off screen.
std::function<int()> declare_screenshot(CLI::App& app);
/// Reproduces an experiment of the paper.
std::function<int()> declare_reproduce(CLI::App& app);
/// Measures speed and memory of the solver.
std::function<int()> declare_bench(CLI::App& app);
/// Measures frame times of the workbench.
std::function<int()> declare_frames(CLI::App& app);
/// Lists the catalogue of effects.
std::function<int()> declare_effects(CLI::App& app);
/// Prints version, libraries and catalogues.
std::function<int()> declare_info(CLI::App& app);

/// The call as recorded in result files: program name without its folder, then the arguments.
const std::vector<std::string>& command_line();
/// Stores the call; to be called once at the start of main(), before threads exist.
void remember_command_line(int argc, const char* const* argv);

}  // namespace myo::app
