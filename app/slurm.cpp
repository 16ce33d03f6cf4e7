#include "slurm.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <system_error>

#include "base/child_process.hpp"
#include "base/files.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupt.hpp"
#include "options.hpp"

namespace myo::app {
namespace {

namespace fs = std::filesystem;

/// A word for the shell, in single quotes if it needs them. An apostrophe ends the quotes, is escaped, and begins them
/// again.
std::string shell_word(const std::string& word) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./=,:+@%").find(c) != std::string_view::npos;
    };
    if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

/// The call without the options that the scripts replace, in both spellings: "--nodes 4" and "--nodes=4".
std::vector<std::string> repeated_words(const std::vector<std::string>& words, const std::string& at_once_option) {
    const std::vector<std::string> flags{"--slurm", "--collect"},
        valued{"--partition", "--time", "--account", "--nodes", "--share", at_once_option};
    const auto among = [](const std::vector<std::string>& list, const std::string& word) {
        return std::find(list.begin(), list.end(), word) != list.end();
    };
    std::vector<std::string> kept;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::size_t equals = words[i].find('=');
        const std::string name = words[i].substr(0, equals);
        if (among(flags, name)) continue;
        if (!among(valued, name))
            kept.push_back(words[i]);
        else if (equals == std::string::npos)
            ++i;  // its value
    }
    return kept;
}

/// Path in an option of #SBATCH: quoted, and % is the sign of Slurm's own names.
std::string log_path(const fs::path& file, const std::string& name) {
    std::string text;
    for (const char c : file.string()) text += c == '%' ? "%%" : std::string(1, c);
    return "\"" + text + "/" + name + "\"";
}

/// First lines of both scripts.
std::string head(const SlurmOptions& options, const std::string& name, const fs::path& logs, const std::string& log) {
    std::string text = "#!/bin/bash\n#SBATCH --job-name=" + name + "\n#SBATCH --nodes=1\n#SBATCH --ntasks=1\n" +
                       "#SBATCH --output=" + log_path(logs, log) + "\n";
    if (!options.partition.empty()) text += "#SBATCH --partition=" + options.partition + "\n";
    if (!options.time.empty()) text += "#SBATCH --time=" + options.time + "\n";
    if (!options.account.empty()) text += "#SBATCH --account=" + options.account + "\n";
    return text;
}

/// A program by name in the folders of PATH; empty if there is none. An empty folder in PATH, the current one for a
/// shell, is skipped.
std::optional<fs::path> found_program(const std::string& name) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    std::error_code code;
    for (std::string folder; std::getline(folders, folder, ':');)
        if (const fs::path file = fs::path(folder) / name; !folder.empty() && fs::is_regular_file(file, code))
            return file;
    return std::nullopt;
}

/// Submits a script. Returns the number of the job. Interrupts end the waiting.
///
/// @param options  further ones of sbatch
/// Errors: sbatch cannot be started or refuses, with its message.
Result<std::string> submitted(const fs::path& sbatch, const std::vector<std::string>& options, const fs::path& script) {
    std::vector<std::string> words{"--parsable"};
    words.insert(words.end(), options.begin(), options.end());
    words.push_back(script.string());
    // Output goes to files, because run_child() has no pipes.
    const fs::path said = script.parent_path() / "sbatch.txt", complaint = script.parent_path() / "sbatch_error.txt";
    const ChildEnd end = run_child({.program = sbatch, .arguments = words, .output = said, .messages = complaint},
                                   [] { return interrupt_flag().load(); });
    const Result<std::string> out = read_file(said), err = read_file(complaint);
    std::error_code ignored;
    fs::remove(said, ignored);
    fs::remove(complaint, ignored);
    if (end.how != ChildEnd::How::exited || end.code != 0 || !out)
        return Error{"sbatch refused " + script.string() + ": " + (err ? *err : "it could not be started"), ""};
    // "17" or "17;cluster"
    const std::string job = out->substr(0, out->find_first_of(";\n"));
    if (job.empty()) return Error{"sbatch did not say the number of its job", script.string()};
    return job;
}

}  // namespace

void add_slurm_options(CLI::App& app, SlurmOptions& options) {
    app.add_flag("--slurm", options.submit,
                 "write an array job and a job that collects into OUT/slurm, and submit them with sbatch");
    const auto add_text = [&](const char* name, std::string& target, const char* help, const char* type) {
        app.add_option(name, target, help)->type_name(type);
    };
    add_text("--partition", options.partition, "with --slurm: partition of the jobs", "P");
    add_text("--time", options.time, "with --slurm: time limit of a task, for example 2:00:00", "T");
    add_text("--account", options.account, "with --slurm: account of the jobs", "A");
    add_count(app, "--nodes", options.nodes,
              "with --slurm: tasks of the array, each on one node (default: one per case, at most " +
                  std::to_string(SlurmPolicy().most_tasks) + ")")
        ->default_str("");
    app.add_flag("--collect", options.collect, "run nothing; make tables and figures of the cases that are finished");
}

Result<void> check_slurm_options(const SlurmOptions& options, const cases::Share& share) {
    const std::pair<const char*, bool> only_with_slurm[] = {{"--partition", !options.partition.empty()},
                                                            {"--time", !options.time.empty()},
                                                            {"--account", !options.account.empty()},
                                                            {"--nodes", options.nodes > 0}};
    for (const auto& [name, given] : only_with_slurm)
        if (given && !options.submit) return Error{"is an option of --slurm", name};
    if (options.submit && options.collect) return Error{"does not go with --slurm", "--collect"};
    if (options.submit && share.parts > 1) return Error{"is chosen by --slurm for each task", "--share"};
    return {};
}

SlurmScripts slurm_scripts(const SlurmOptions& options, const SlurmJob& job, const fs::path& program,
                           const std::vector<std::string>& words, const fs::path& folder, const SlurmPolicy& policy) {
    SlurmScripts scripts;
    // More tasks than cases would wait in the queue for nothing.
    scripts.tasks = std::max(1, std::min(job.cases, options.nodes > 0 ? options.nodes : policy.most_tasks));
    // The task works in the folder of the call, as its words name files relative to it; exec passes signals of Slurm on
    // to the program.
    std::string call = "set -euo pipefail\ncd -- " + shell_word(folder.string()) + "\nexec " +
                       shell_word(program.string());
    for (const std::string& word : repeated_words(words, job.at_once_option)) call += " " + shell_word(word);
    const fs::path logs = fs::absolute(job.out) / "slurm";
    const std::string tasks = std::to_string(scripts.tasks), processors = std::to_string(job.at_once);
    // Task i of the array runs share i of `tasks`.
    scripts.array = head(options, job.name, logs, "task_%a.txt") + "#SBATCH --array=1-" + tasks +
                    "\n#SBATCH --cpus-per-task=" + processors + "\n" + call + " --share \"$SLURM_ARRAY_TASK_ID/" +
                    tasks + "\" " + job.at_once_option + " " + processors + "\n";
    scripts.collect = head(options, job.name + "-collect", logs, "collect.txt") + call + " --collect\n";
    return scripts;
}

int submit_to_slurm(const SlurmOptions& options, const SlurmJob& job, Console& console) {
    std::error_code code;
    const fs::path program = fs::read_symlink("/proc/self/exe", code), folder = fs::current_path(code);
    std::vector<std::string> words = command_line();
    // The first word is the name of the program; the scripts call it by its path.
    if (!words.empty()) words.erase(words.begin());
    const SlurmScripts scripts = slurm_scripts(options, job, program, words, folder);
    const fs::path array = job.out / "slurm" / "array.sh", collect = job.out / "slurm" / "collect.sh";
    // Written before sbatch is looked for: the scripts can be submitted elsewhere.
    for (const auto& [file, text] : {std::pair{array, scripts.array}, std::pair{collect, scripts.collect}})
        if (const Result<void> written = write_file(file, text); !written) return console.refuse(written.error());
    const std::optional<fs::path> sbatch = found_program("sbatch");
    if (!sbatch)
        return console.refuse({"sbatch is not in PATH, so nothing is submitted; the jobs are written to " +
                                   array.string() + " and " + collect.string(),
                               "--slurm"});
    const Result<std::string> first = submitted(*sbatch, {}, array);
    if (!first) return console.fail(first.error());
    // After any end: cases that failed are rows as well.
    const Result<std::string> second = submitted(*sbatch, {"--dependency=afterany:" + *first}, collect);
    if (!second)
        return console.fail({second.error().what + "; job " + *first +
                                 " runs the cases, and the same call with --collect instead of --slurm collects them",
                             ""});
    console.print(std::to_string(job.cases) + " cases in " + std::to_string(scripts.tasks) + " tasks: job " + *first +
                  "; job " + *second + " collects the results in " + job.out.string() + " (squeue -j " + *first + "," +
                  *second + ")");
    return status_done;
}

}  // namespace myo::app
