#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>

#include "base/files.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_status.hpp"
#include "options.hpp"
#include "slurm.hpp"
#include "validation/defaults_summary.hpp"
#include "validation/defaults_validation.hpp"
#include "validation/validation.hpp"
#include "validation/validation_report.hpp"

namespace myo::app {
namespace {

/// Parsed call of `myoloop validate`.
struct ValidateCall {
    // Which cases are drawn, and which of them this process runs.
    validation::ValidationOptions options;
    bool defaults = false;  // validates the defaults of calibrate instead of the diagnosis
    std::filesystem::path out;
    WorkOptions work;
    SlurmOptions slurm;
};

/// One case: number, body ("+": with muscles), truth, level in multiples of the noise, right, group or WRONG, answer,
/// confidence, time. A truth in parentheses was withheld from the diagnosis.
std::string record_line(const validation::CaseRecord& r) {
    char line[256];
    const std::string truth = r.kind == validation::CaseKind::deleted ? "(" + r.truth + ")" : r.truth;
    const std::string answer = r.answered() ? join(r.answer, " + ") : "failed: " + r.failure;
    std::snprintf(line, sizeof line, "%5d  %-6s %-24s %6.1f x  %s %-40.110s %5.2f  %5.0f s", r.number,
                  (r.family + (r.muscles ? "+" : "")).c_str(), truth.c_str(), r.level,
                  r.right()              ? "right"
                  : r.right_or_grouped() ? "group"
                                         : "WRONG",
                  answer.c_str(), r.confidence, r.diagnose_s);
    return line;
}

/// Prints the summary and writes validation.json and validation.html of all cases that the folder holds; nothing if
/// there are none. Returns the exit status.
template <class Record, class Summary>
int write_summary(const ValidateCall& call, const Summary& summary, const report::HtmlReport& report, Console& console,
                  const std::vector<Record>& records) {
    if (records.empty()) return status_done;
    console.print("\n" + validation::summary_text(summary));
    if (const Result<void> file = report::write_json(call.out / "validation.json", validation::summary_json(summary));
        !file)
        return console.fail(file.error());
    if (const Result<void> page = report::write_html(call.out / "validation.html", report); !page)
        return console.fail(page.error());
    console.print("\nreport: " + (call.out / "validation.html").string());
    return status_done;
}

/// Validation of the diagnosis: runs missing cases, then summarises all records of the folder.
int diagnosis_validation(const ValidateCall& call, const Progress& progress, Console& console) {
    int finished = 0;
    const Result<void> run = validation::run_validation(call.options, call.out, progress,
                                                        [&](const validation::CaseRecord& record) {
                                                            console.print(record_line(record));
                                                            ++finished;
                                                        });
    // After the first finished case only writing its record can fail, which is no mistake of the call.
    if (!run) return finished > 0 ? console.fail(run.error()) : console.refuse(run.error());
    const Result<std::vector<validation::CaseRecord>> records = validation::validation_records(call.out);
    if (!records) return console.refuse(records.error());
    const validation::ValidationSummary summary = validation::validation_summary(*records);
    if (!records->empty())
        if (const Result<void> file = write_file(call.out / "reliability.svg", validation::reliability_figure(summary));
            !file)
            return console.fail(file.error());
    return write_summary(call, summary, validation::validation_report(*records, join(command_line(), " ")), console,
                         *records);
}

/// Validation of the defaults: runs missing cases, then summarises all records of the folder.
int defaults_validation(const ValidateCall& call, const Progress& progress, Console& console) {
    int finished = 0;
    const Result<void> run = validation::run_defaults_validation({call.options.choice.seed, call.options.range},
                                                                 call.out, progress,
                                                                 [&](const validation::DefaultsRecord& record) {
                                                                     console.print(validation::record_line(record));
                                                                     ++finished;
                                                                 });
    if (!run) return finished > 0 ? console.fail(run.error()) : console.refuse(run.error());
    const Result<std::vector<validation::DefaultsRecord>> records = validation::defaults_records(call.out);
    if (!records) return console.refuse(records.error());
    return write_summary(call, validation::defaults_summary(*records),
                         validation::defaults_report(*records, join(command_line(), " ")), console, *records);
}

/// Checks the call, then submits, or runs missing cases and summarises.
int run_validate(ValidateCall call) {
    Console console(call.work.quiet, call.work.json_progress);
    if (call.out.empty()) return console.refuse({"name a folder for the results", "--out"});
    const validation::CaseChoice& choice = call.options.choice;
    // Options of the validation of the diagnosis would be ignored silently.
    if (call.defaults && !(choice.families.empty() && choice.effects.empty() && choice.together == 1))
        return console.refuse(
            {"draws its own bodies and has no effects; leave --geometry, --effects and --together out", "--defaults"});
    if (const Result<void> fine = check_slurm_options(call.slurm, call.options.range.share); !fine)
        return console.refuse(fine.error());
    // Tasks of the array run the cases; this process only submits.
    if (call.slurm.submit)
        return submit_to_slurm(call.slurm,
                               {.name = "myoloop-validate",
                                .out = call.out,
                                .cases = call.options.range.cases,
                                .at_once_option = "--threads",
                                .at_once = std::max(1, call.work.threads)},
                               console);
    // No case is run: what follows summarises the records of the folder.
    if (call.slurm.collect) call.options.range.cases = 0;
    // Equal seeds draw equal cases.
    call.options.choice.seed = call.work.seed.value_or(1);
    call.options.range.threads = call.work.threads > 0 ? call.work.threads : hardware_threads();
    const Progress progress = console.progress();
    const int status = call.defaults ? defaults_validation(call, progress, console)
                                     : diagnosis_validation(call, progress, console);
    if (status != status_done || !progress.cancelled()) return status;
    console.complain("stopped; finished cases are kept in " + call.out.string() +
                     ", the same call continues from them");
    return status_stopped;
}

/// Value of --first. Throws CLI::ValidationError.
void read_first(const std::string& text, cases::CaseRange& range) {
    int value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size() || value < 0)
        throw CLI::ValidationError("--first", "'" + text + "' is not a whole number from 0 on");
    range.first = value;
}

/// Value of --geometry. Throws CLI::ValidationError for an unknown body.
void read_families(const std::string& text, std::vector<validation::BodyFamily>& families) {
    families.clear();
    for (const std::string& id : split_words(text)) {
        validation::BodyFamily family{};
        if (!validation::parse_body_family(id, family))
            throw CLI::ValidationError("--geometry", unknown_word(id, validation::body_family_ids()));
        families.push_back(family);
    }
}

}  // namespace

std::function<int()> declare_validate(CLI::App& app) {
    const auto call = std::make_shared<ValidateCall>();
    app.add_option("--out", call->out,
                   "folder for cases and results, made when missing; finished cases in it are not repeated")
        ->type_name("DIR");
    // Options of the two kinds of validation are declared together; run_validate() refuses those that do not apply.
    app.add_flag("--defaults", call->defaults,
                 "calibrate random experiments with nothing but defaults instead: how often are numbers wrong without "
                 "a warning?");
    add_count(app, "--cases", call->options.range.cases, "number of cases (default: 24)");
    app.add_option_function<std::string>(
           "--first", [call](const std::string& text) { read_first(text, call->options.range); },
           "number of the first case (default: 0); case k is the same for any count")
        ->type_name("K");
    add_share(app, call->options.range.share);
    app.add_option_function<std::string>(
           "--geometry", [call](const std::string& text) { read_families(text, call->options.choice.families); },
           "bodies: " + join(validation::body_family_ids()) + " (default: all that suit the effect)")
        ->type_name("A,B");
    add_effect_list(app, "--effects", call->options.choice.effects,
                    "effects to draw from (default: all of the catalogue)");
    add_count(app, "--together", call->options.choice.together,
              "effects that act at once in the cases with known effects, at most 4 (default: 1)");
    add_work_options(app, call->work);
    add_slurm_options(app, call->slurm);
    return [call] { return run_validate(*call); };
}

}  // namespace myo::app
