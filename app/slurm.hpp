#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "cases/case_range.hpp"
#include "console.hpp"

// Commands of many cases on a cluster: an array job with a share of the cases per task, and a job that collects.

namespace myo::app {

/// Options that hand a command to Slurm.
struct SlurmOptions {
    // At most one of the two is set.
    bool submit = false;   // writes and submits the jobs instead of running cases
    bool collect = false;  // only makes tables and figures of finished cases
    // As sbatch takes them; empty: its defaults. Valid with --slurm only.
    std::string partition, time, account;
    int nodes = 0;  // tasks of the array; 0: chosen by SlurmPolicy
};

/// Adds --slurm, --partition, --time, --account, --nodes and --collect.
void add_slurm_options(CLI::App& app, SlurmOptions& options);

/// Rejects options that would be ignored silently: those of Slurm without --slurm, --collect or --share with it.
///
/// @param share  of the call; each task of the array gets its own
Result<void> check_slurm_options(const SlurmOptions& options, const cases::Share& share);

/// Limits of what is submitted.
struct SlurmPolicy {
    int most_tasks = 32;  // of an array if no number is given; a task is one entry of the queue
};

/// A command of many cases.
struct SlurmJob {
    std::string name;           // "myoloop-sweep"
    std::filesystem::path out;  // folder of the results, on a file system that all nodes share
    // Number of cases; there are never more tasks than cases.
    int cases = 0;
    std::string at_once_option;  // cases at a time in one process: "--jobs"
    int at_once = 1;             // processors of a task
};

/// Scripts for sbatch.
struct SlurmScripts {
    int tasks = 1;
    // Text of a bash script; paths in it are absolute.
    std::string array;    // each task repeats the call for its share
    std::string collect;  // repeats it with --collect
};

/// Makes the scripts.
///
/// @param program  absolute path
/// @param words    the call behind the name of the program, also with options of Slurm, which are left out
/// @param folder   the working directory, against which words name files
SlurmScripts slurm_scripts(const SlurmOptions& options, const SlurmJob& job, const std::filesystem::path& program,
                           const std::vector<std::string>& words, const std::filesystem::path& folder,
                           const SlurmPolicy& policy = {});

/// Writes the scripts into OUT/slurm and submits them, the second one to begin after the first has ended. Returns the
/// exit status; without sbatch that of a wrong call, with the scripts written.
int submit_to_slurm(const SlurmOptions& options, const SlurmJob& job, Console& console);

}  // namespace myo::app
