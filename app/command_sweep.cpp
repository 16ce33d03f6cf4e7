#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <system_error>

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_status.hpp"
#include "options.hpp"
#include "results/output_files.hpp"
#include "slurm.hpp"
#include "sweep/run_sweep.hpp"
#include "sweep/sweep_report.hpp"

namespace myo::app {
namespace {

namespace fs = std::filesystem;

/// Parsed call of `myoloop sweep`.
struct SweepCall {
    fs::path file, out;
    int jobs = 0;  // 0: all processors
    bool list = false;
    // Program, share and treatment of earlier cases; see SweepRun.
    sweep::SweepRun run;
    SlurmOptions slurm;
    WorkOptions work;
};

/// Parses arguments as the command will, without running it: a mistake is found before the first case, not in each.
///
/// @param command  a known one
/// @param words    as in the sweep file, without experiment and output folder
/// Errors: the message of the parser; an argument that the command does not take.
Result<void> check_arguments(const std::string& command, const std::vector<std::string>& words) {
    const auto known = std::find_if(commands().begin(), commands().end(),
                                    [&](const Subcommand& c) { return c.name == command; });
    CLI::App app("", "myoloop " + command);
    app.allow_extras();
    const std::function<int()> action = known->declare(app);  // owns what the options write to
    // CLI11 takes words from the back. "EXP" stands for the experiment, which comes first.
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    reversed.emplace_back("EXP");
    try {
        app.parse(reversed);
    } catch (const CLI::ParseError& error) {
        return Error{error.what(), ""};
    }
    if (!app.remaining().empty()) return Error{surplus_arguments(app), ""};
    return {};
}

/// Cases by their state: "12 cases: 10 done, 2 failed".
std::string count_words(const sweep::SweepTable& table) {
    const std::size_t cases = table.rows.size();
    std::string words = std::to_string(cases) + (cases == 1 ? " case: " : " cases: ") +
                        std::to_string(table.count(sweep::CaseState::done)) + " done";
    for (const sweep::CaseState state : {sweep::CaseState::unconverged, sweep::CaseState::failed})
        if (const int count = table.count(state); count > 0)
            words += ", " + std::to_string(count) + " " + to_string(state);
    if (table.missing() > 0) words += ", " + std::to_string(table.missing()) + " not run yet";
    return words;
}

/// Prints every case with its state, and its command.
int list_cases(const SweepCall& call, const sweep::PreparedSweep& sweep, Console& console) {
    const sweep::SweepTable table = sweep::sweep_table(sweep, call.out);
    for (const sweep::SweepRow& row : table.rows) console.print(sweep::row_line(table.sweep, row));
    console.print(count_words(table));
    return status_done;
}

/// Table and figures of all cases of the folder.
int collect(const SweepCall& call, const sweep::PreparedSweep& sweep, Console& console) {
    const sweep::SweepTable table = sweep::sweep_table(sweep, call.out);
    if (const Result<void> written = sweep::write_sweep(table, call.out, MYOLOOP_VERSION, command_line()); !written)
        return console.fail(written.error());
    console.print(count_words(table) + "\ntable: " + (call.out / "sweep.csv").string() +
                  "\nreport: " + (call.out / "sweep.html").string());
    // Single failures are rows of the table; only a sweep without any other row has failed itself.
    if (table.count(sweep::CaseState::failed) < static_cast<int>(table.rows.size())) return status_done;
    console.complain("every case failed, the first with: " + table.rows.front().message);
    return status_failed;
}

/// Runs the missing cases and prints each when it ends, then collects. Returns the exit status.
int run_cases(const SweepCall& call, const sweep::PreparedSweep& sweep, Console& console) {
    const Progress progress = console.progress();
    int ended = 0;
    const Result<void> run = sweep::run_sweep(
        sweep, call.out, call.run, progress, [&](const sweep::SweepCase& c, const sweep::CaseMarker& marker) {
            ++ended;
            console.print(sweep::row_line(sweep.sweep, sweep::sweep_row(sweep, c, marker, call.out)));
        });
    // After the first case only writing can fail, which is no mistake of the call.
    if (!run) return ended > 0 ? console.fail(run.error()) : console.refuse(run.error());
    if (!progress.cancelled()) return collect(call, sweep, console);
    console.complain("stopped; finished cases are kept in " + call.out.string() +
                     ", the same call continues from them");
    return status_stopped;
}

/// Checks the call, then lists, collects, submits or runs.
int run_sweep_command(SweepCall call) {
    Console console(call.work.quiet, call.work.json_progress);
    if (call.file.empty()) return console.refuse({"name a sweep file", ""});
    if (call.out.empty()) return console.refuse({"name a folder for the results", "--out"});
    if (const Result<void> fine = check_slurm_options(call.slurm, call.run.share); !fine)
        return console.refuse(fine.error());
    const Result<sweep::Sweep> read = sweep::read_sweep(call.file);
    if (!read) return console.refuse(read.error());
    // Every case is prepared before the first one runs, so that errors of the file are known at once.
    const Result<sweep::PreparedSweep> sweep = sweep::prepare_sweep(*read, check_arguments, MYOLOOP_VERSION);
    if (!sweep) return console.refuse(sweep.error());
    if (call.list) return list_cases(call, *sweep, console);
    if (const Result<void> folder = results::prepare_output_folder(call.out); !folder)
        return console.refuse({folder.error().text(), "--out"});
    if (call.slurm.collect) return collect(call, *sweep, console);
    if (call.slurm.submit)
        return submit_to_slurm(call.slurm,
                               {.name = "myoloop-sweep",
                                .out = call.out,
                                .cases = static_cast<int>(sweep->cases.size()),
                                .at_once_option = "--jobs",
                                .at_once = std::max(1, call.jobs)},
                               console);
    std::error_code code;
    // Each case runs this program as a child.
    call.run.program = fs::read_symlink("/proc/self/exe", code);
    call.run.jobs = call.jobs > 0 ? call.jobs : hardware_threads();
    return run_cases(call, *sweep, console);
}

}  // namespace

std::function<int()> declare_sweep(CLI::App& app) {
    const auto call = std::make_shared<SweepCall>();
    app.add_option("SWEEP", call->file, "sweep file: experiment, command, and what varies")->type_name("");
    app.add_option("--out", call->out,
                   "folder for cases and results, made when missing; finished cases in it are not repeated")
        ->type_name("DIR");
    add_count(app, "--jobs", call->jobs, "cases at a time, one thread each (default: one per processor)")
        ->default_str("");
    add_share(app, call->run.share);
    app.add_flag("--retry", call->run.retry, "repeat the cases that failed");
    app.add_flag("--replace", call->run.replace,
                 "repeat finished cases whose values, options or data have changed since, instead of refusing them");
    app.add_flag("--list", call->list, "run nothing; print the cases");
    add_slurm_options(app, call->slurm);
    add_console_options(app, call->work);
    return [call] { return run_sweep_command(*call); };
}

}  // namespace myo::app
