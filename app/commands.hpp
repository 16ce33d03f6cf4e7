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
///
/// Writes simulate.json, a trace per trial, and on request VTU series.
std::function<int()> declare_simulate(CLI::App& app);
/// Finds the effect that the declared model lacks.
///
/// Writes report.json and a copy of it under the name of the experiment, experiment_augmented.toml, traces,
/// report.html, the fits for --resume, and the signal of the proposed next trial if it has one.
std::function<int()> declare_diagnose(CLI::App& app);
/// Lists which effects of which size an experiment could reveal.
///
/// Writes power.json and power.html into a folder, or the JSON file alone, only on request.
std::function<int()> declare_power(CLI::App& app);
/// Proposes the trial that best separates two sets of effects. Fails if no trial can be run.
///
/// Writes proposal.json, next_trial.toml with its signal, and proposal.html, only on request.
std::function<int()> declare_propose(CLI::App& app);
/// Validates diagnosis or defaults on synthetic experiments.
///
/// Writes a folder per case, a line per case in cases.jsonl, and a summary of all cases that the folder holds.
std::function<int()> declare_validate(CLI::App& app);
/// Runs a command on many variants of an experiment. Fails if every case failed.
///
/// Writes a folder per case, sweep.csv, sweep.json and sweep.html.
std::function<int()> declare_sweep(CLI::App& app);
/// Fits the declared unknowns. Fails if the fit did not converge; the best values are written nevertheless.
///
/// Writes calibrate.json, a trace per trial and report.html.
std::function<int()> declare_calibrate(CLI::App& app);
/// Finds the actuation that follows a recorded motion or reaches goals, and what is sought of the body.
///
/// Writes optimize.json, signals and simulated markers of the trial, report.html, and with --seek the experiment with
/// the found body.
std::function<int()> declare_optimize(CLI::App& app);
/// Compares the adjoint gradient with finite differences. Fails if one parameter differs by more than 1e-5.
///
/// Writes a JSON file only on request.
std::function<int()> declare_gradcheck(CLI::App& app);
/// Meshes a surface or checks a volume mesh. Prints the quality as text or JSON; writes a VTU file only on request.
std::function<int()> declare_mesh(CLI::App& app);
/// Draws the workbench off screen into a PNG file.
std::function<int()> declare_screenshot(CLI::App& app);
/// Reproduces an experiment of the paper. Writes <case>.json, figures and report.html.
std::function<int()> declare_reproduce(CLI::App& app);
/// Measures speed and memory of the solver. Goals and targets that are missed are printed, but are no failure.
std::function<int()> declare_bench(CLI::App& app);
/// Measures frame times of the workbench. Goals that are missed are no failure.
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
