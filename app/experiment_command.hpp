#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/folder_lock.hpp"
#include "base/stopwatch.hpp"
#include "console.hpp"
#include "options.hpp"
#include "prediction/run_trials.hpp"
#include "results/output_json.hpp"
#include "setup/setup.hpp"

// Common part of the commands on an experiment folder: options, opening, messages.

namespace myo::app {

/// When time steps are chosen, if none is requested.
enum class StepChoice {
    before,         // before the command runs
    in_run,         // by the run, from the vibrations that it shows
    half_interval,  // not chosen: half a sampling interval. A search adapts it later; a single run keeps it, because a
                    // choice takes several runs
};

/// Parsed call of a command on an experiment folder.
struct ExperimentCall {
    std::filesystem::path experiment;  // folder or .toml file
    std::filesystem::path out;         // folder for results
    bool writes_folder = true;         // false: no folder is made or locked
    StepChoice step_choice = StepChoice::before;
    bool fits = false;  // the command fits values, which validation trials may test
    int leave_out = 0;  // fit trials that become validation trials, drawn by the seed
    /// Files that the command may write for an experiment; none may be an input.
    std::function<std::vector<std::filesystem::path>(const experiment::Experiment&)> outputs;
    std::string trial;  // for commands with --trial; empty: default
    /// Ids of effects that options name, by option: of the catalogue, or laws of the experiment.
    std::vector<std::pair<std::string, const std::vector<std::string>*>> named_effects{};
    WorkOptions work;
    SetupOptions setup;
};
/// Adds the common options to a command: experiment, --out, those of add_setup_options() and add_work_options().
///
/// @param call  receives the values at parsing; must outlive `app`, as in all functions of this file that add options
void declare_experiment_call(CLI::App& app, ExperimentCall& call);

/// Adds an option that names effects, "A,B": of the catalogue, or laws of the experiment. Unknown ones are refused once
/// the experiment is read.
void add_named_effects(CLI::App& app, const std::string& name, std::vector<std::string>& target,
                       const std::string& help, ExperimentCall& call);

/// Adds --leave-out to a command that fits.
void declare_leave_out(CLI::App& app, ExperimentCall& call);

/// Mean distances of prediction and measurement over trials of a role, of two runs: "mean distance of the predicted
/// trials [mm]  15.2  6.1"; empty if there is none.
std::string distance_line(const prediction::SetupRun& before, const prediction::SetupRun& after);

/// Paths of the traces of all trials and of files of these names in the output folder, for ExperimentCall::outputs.
std::vector<std::filesystem::path> trace_files_and(const ExperimentCall& call, const experiment::Experiment& experiment,
                                                   const std::vector<std::string>& names);

/// Whether a command works on all trials or on one.
enum class TrialChoice { all, one };

/// A prepared experiment, or the reason to end the command.
struct OpenedExperiment {
    std::optional<setup::Setup> setup;  // empty: the command ends with `status`, the reason is printed
    int status = 0;
    experiment::Experiment experiment;    // complete, also if the setup has one trial
    Stopwatch stopwatch;                  // since the command began
    std::optional<FolderLock> lock = {};  // on the output folder
    /// Findings printed before the choice of steps, which takes long if a unit is wrong.
    std::vector<check::Finding> told = {};
};

/// The TOML file of the experiment of a call.
std::filesystem::path declaration_of(const ExperimentCall& call);

/// Reads and prepares the experiment of a command, reduced to one trial (with_one_trial) for TrialChoice::one. An
/// unknown call.trial is rejected in both cases. The integration is checked as well, unless the run chooses its steps
/// (StepChoice::in_run).
///
/// @param first_result  what an early cancellation prevents, for the message "stopped before <first_result>; ..."
/// Errors: in `status`, already printed: those of the call, of the input and of the output folder; outputs that would
/// replace an input; --resolution or --dt that exceed the memory.
OpenedExperiment open_command(const ExperimentCall& call, TrialChoice choice, const std::string& first_result,
                              Console& console, const Progress& progress);

/// First result of calibrations and searches for signals.
inline constexpr const char* first_evaluation = "the first evaluation was complete";

/// Reports a cancellation before anything was written; returns status_stopped.
int stopped_before(const std::string& first_result, Console& console);

/// Prints findings as warnings, unless a warning states them already or they are among those printed before.
void tell_findings(const std::vector<check::Finding>& findings, const std::vector<check::Finding>& before,
                   Console& console);

/// Facts about this run for result files, without findings; peak memory is that of the process so far.
///
/// @param setup_s  wall-clock time of reading and preparing [s]
results::RunFacts run_facts(const ExperimentCall& call, double setup_s);

/// Note on the assumed damping if none is declared, else empty.
std::string assumed_damping(const setup::Setup& setup);

/// Summary: "64 hex8 elements of 5 mm, 2 layers across 10 mm, 375 degrees of freedom, tr_bdf2, 2 threads".
std::string size_line(const setup::Setup& setup);

/// Right-aligned millimetres, "  0.312" for 3.12e-4 m; "-" if not finite.
std::string in_millimetres(double metres);

/// Reason for a failed run; if a smaller step may help, with the options that may help.
std::string with_options(const std::string& failure);

}  // namespace myo::app
