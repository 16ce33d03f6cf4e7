#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/folder_lock.hpp"
#include "base/stopwatch.hpp"
#include "console.hpp"
#include "options.hpp"
#include "results/output_json.hpp"
#include "setup/setup.hpp"

// What the commands on an experiment folder have in common.

namespace myo::app {

/// When the steps of trials are chosen, where nobody asks for one.
enum class StepChoice {
    before,         // the command runs
    in_run,         // by the run itself, which looks at its own vibrations
    half_interval,  // they begin as half a sampling interval: what is sought tells, or each trial runs once, which is
                    // cheaper than to look for its step
};

struct ExperimentCall {
    std::filesystem::path experiment;
    std::filesystem::path out;
    bool writes_folder = true;  // false: the command has no --out
    StepChoice step_choice = StepChoice::before;
    bool fits = false;  // the command fits values, which trials may test
    /// Files that the command may write for an experiment; none of them may be one that it reads.
    std::function<std::vector<std::filesystem::path>(const experiment::Experiment&)> outputs;
    std::string trial;  // of commands with --trial
    WorkOptions work;
    SetupOptions setup;
};
void declare_experiment_call(CLI::App& app, ExperimentCall& call);

/// The traces of all trials and files of these names, in the folder of results: what a command has as outputs.
std::vector<std::filesystem::path> trace_files_and(const ExperimentCall& call, const experiment::Experiment& experiment,
                                                   const std::vector<std::string>& names);

enum class TrialChoice { all, one };

/// How a command on an experiment begins.
struct OpenedExperiment {
    std::optional<setup::Setup> setup;  // none: the command ends with `status`, and why has been said
    int status = 0;
    experiment::Experiment experiment;      // all of it
    Stopwatch stopwatch;                    // since the beginning
    std::optional<FolderLock> lock = {};    // of the folder of results
    std::vector<check::Finding> told = {};  // before steps were looked for: with a slip in a unit that may take long
};

/// Reads and prepares the setup, of one trial alone (with_one_trial) when the command is on one. A call.trial that is
/// not known is refused either way.
///
/// Errors: the call's, the input's, those of the output folder, outputs that would replace an input; --resolution or
/// --dt that would make more than the memory holds. The integration is checked, too.
/// @param first_result  what a user who stops it now does not get: "stopped before <first_result>; nothing was written"
OpenedExperiment open_command(const ExperimentCall& call, TrialChoice choice, const std::string& first_result,
                              Console& console, const Progress& progress);

/// What calibrations and searches for signals have first.
inline constexpr const char* first_evaluation = "the first evaluation was complete";

/// Says so on the console; the exit status of a command stopped before anything was written.
int stopped_before(const std::string& first_result, Console& console);

/// Says what checks have found that no warning has said, and that is not among those said before.
void tell_findings(const std::vector<check::Finding>& findings, const std::vector<check::Finding>& before,
                   Console& console);

results::RunFacts run_facts(const ExperimentCall& call, double setup_s);

/// "damping 3 ms is assumed, for none is declared", or empty.
std::string assumed_damping(const setup::Setup& setup);

/// "64 hex8 elements of 5 mm, 2 layers across 10 mm, 375 degrees of freedom, tr_bdf2, 2 threads"
std::string size_line(const setup::Setup& setup);

/// "  0.312" for 3.12e-4 m; "-" when there is no number.
std::string in_millimetres(double metres);

/// Why a run failed; where a smaller step may help, with the options that choose it and what else may help there.
std::string with_options(const std::string& failure);

}  // namespace myo::app
