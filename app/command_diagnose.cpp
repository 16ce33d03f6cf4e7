#include <algorithm>
#include <cstdio>
#include <memory>
#include <system_error>

#include "base/files.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "commands.hpp"
#include "diagnosis/report/augmented_experiment.hpp"
#include "diagnosis/report/diagnosis_json.hpp"
#include "diagnosis/report/diagnosis_report.hpp"
#include "diagnosis/report/effect_words.hpp"
#include "diagnosis/screening/confusion.hpp"
#include "diagnosis/whole_diagnosis.hpp"
#include "exit_status.hpp"
#include "experiment_command.hpp"
#include "next_experiment.hpp"
#include "planning/proposal_output.hpp"
#include "results/finding_output.hpp"
#include "results/output_files.hpp"
#include "results/output_json.hpp"

namespace myo::app {
namespace {

/// Parsed call of `myoloop diagnose`.
struct DiagnoseCall : ExperimentCall {
    std::vector<std::string> without;      // effects that are not considered
    bool resume = false;                   // reuses stored fits
    std::optional<double> search_limit_s;  // s after the start
};

const char* const fits_file = "diagnose_fits.json";
const char* const augmented_file = "experiment_augmented.toml";

/// Name of the experiment's folder, under which the report is stored as well.
std::string report_name(const experiment::Experiment& experiment) {
    return std::filesystem::weakly_canonical(experiment.folder).filename().string();
}

/// Candidates in the order of the screening, with rms, held-out rms, systematic residual and weight of those fitted.
std::string candidate_lines(const diagnosis::Diagnosis& d) {
    char line[256];
    std::snprintf(line, sizeof line, "%-22s %10s %12s %12s %12s %8s", "candidate", "explains", "rms [mm]", "held out",
                  "systematic", "weight");
    std::string text = line;
    // rms in mm; held-out and systematic residuals in multiples of the noise; weights sum to 1 over all fits.
    std::snprintf(line, sizeof line, "\n%-22s %10s %12.4f %10.3f x %10.3f x %8.3f", "(declared)", "",
                  1e3 * d.declared.rms_m, d.declared.held_out_rms, d.declared.tests.systematic.rms, d.declared.weight);
    text += line;
    int shown = 0;
    for (const diagnosis::Candidate& c : d.candidates) {
        // The screening puts the most promising first; the report has the others.
        if (++shown > 12) break;
        if (!c.judged)
            std::snprintf(line, sizeof line, "\n%-22s %8.1f %%", c.score.id.c_str(),
                          100.0 * (c.score.usable() ? c.score.test.explained : 0.0));
        else
            std::snprintf(line, sizeof line, "\n%-22s %8.1f %% %12.4f %10.3f x %10.3f x %8.3f", c.score.id.c_str(),
                          100.0 * c.score.test.explained, 1e3 * c.judged->rms_m, c.judged->held_out_rms,
                          c.judged->tests.systematic.rms, c.judged->weight);
        text += line;
        if (c.judged) text += "  " + diagnosis::parameter_words(c.judged->fit.effects.front().parameters);
    }
    for (const diagnosis::JudgedFit& set : d.sets) {
        std::snprintf(line, sizeof line, "\n%-22s %10s %12.4f %10.3f x %10.3f x %8.3f  ", "set", "", 1e3 * set.rms_m,
                      set.held_out_rms, set.tests.systematic.rms, set.weight);
        text += line;
        for (const effect::EffectDeclaration& effect : set.fit.effects) text += diagnosis::effect_words(effect) + " ";
    }
    return text;
}

/// Verdict with confidence, reason, confusable effects, notes and inferred force.
std::string verdict_lines(const diagnosis::Diagnosis& d) {
    std::string text = "verdict: ";
    if (d.verdict.kind == diagnosis::VerdictKind::none) text += "none";
    if (d.verdict.kind == diagnosis::VerdictKind::unknown) text += "unknown";
    for (const effect::EffectDeclaration& effect : d.verdict.effects) text += diagnosis::effect_words(effect) + "  ";
    text += " (confidence " + format_number(d.verdict.confidence, 3) + ")\n" + d.verdict.reason;
    for (const diagnosis::Confusion& c : diagnosis::confusions_of_verdict(d))
        text += (diagnosis::is_decided(d, c) ? "\nsimilar here, but the fits decide: " : "\nconfounded here: ") +
                c.first + " and " + c.second + " (cosine " + format_number(c.cosine, 4) + "); " + c.next_experiment +
                " would separate them";
    for (const std::string& note : d.notes) text += "\nnote: " + note;
    // A missing force is inferred only if no effect explains the residual.
    if (d.missing_force && !d.missing_force->failure.empty())
        text += "\nno force is inferred: " + d.missing_force->failure;
    if (d.missing_force && !d.missing_force->modes.empty())
        text += "\na force would explain " + format_number(100.0 * d.missing_force->removed(), 3) +
                " % of the residual of " + d.missing_force->trial + ": up to " +
                format_number(d.missing_force->modes.front().peak_N(), 3) + " N " +
                d.missing_force->modes.front().where;
    return text;
}

/// rms per trial [mm] with the declared model and with the effects of the verdict, and the errors of sensors.
std::string trial_lines(const setup::Setup& setup, const diagnosis::Diagnosis& d) {
    std::string text;
    char line[256];
    for (const setup::PreparedTrial& trial : setup.trials) {
        const prediction::TrialScore* const before = results::find_score(d.before, trial.name);
        const prediction::TrialScore* const after = results::find_score(d.after, trial.name);
        std::snprintf(line, sizeof line, "%s%-24.80s %-10s %s %s", text.empty() ? "" : "\n", trial.name.c_str(),
                      result_word(trial.role).c_str(), in_millimetres(before ? before->rms_m : std::nan("")).c_str(),
                      in_millimetres(after ? after->rms_m : std::nan("")).c_str());
        text += line;
    }
    return text + results::sensor_lines(d.before, "before") + results::sensor_lines(d.after, "after");
}

/// Wall-clock time per part of the diagnosis.
std::string cost_lines(const diagnosis::Diagnosis& d) {
    std::string text = "time:";
    for (const diagnosis::PhaseCost& cost : d.cost)
        text += " " + cost.phase + " " + format_number(cost.seconds, 3) + " s,";
    return text + " all " + format_number(d.seconds, 3) + " s";
}

/// Writes both JSON reports, the augmented experiment, traces and report.html.
///
/// @param next  trial that would separate what this diagnosis could not; empty: none is proposed
Result<void> write_results(const DiagnoseCall& call, const experiment::Experiment& experiment,
                           const setup::Setup& setup, const diagnosis::Diagnosis& d,
                           const std::optional<planning::Proposal>& next, const results::RunFacts& facts) {
    // The augmented experiment is an edited copy of the declaration, which keeps its comments.
    const std::string name = report_name(experiment);
    report::Json report = diagnosis::diagnosis_json(setup, d, name);
    report["checks"] = results::findings_json(facts.findings);
    report::HtmlReport page = diagnosis::diagnosis_report(setup, d, facts);
    if (next) {
        report["verdict"]["next_experiment"] = planning::next_experiment_json(*next);
        page.sections.push_back(planning::proposal_section(*next, planning::PlanningPolicy().proposal));
        if (const Result<void> signal = write_signal(call.out, *next); !signal) return signal.error();
    }
    // Under the name of the experiment as well, so that reports of several experiments can be gathered in one folder.
    for (const std::string& file : {std::string("report.json"), name + ".json"})
        if (const Result<void> json = report::write_json(call.out / file, report); !json) return json.error();
    const Result<std::string> augmented = diagnosis::augmented_experiment(declaration_of(call), d.verdict.effects,
                                                                          call.out);
    if (!augmented) return augmented.error();
    if (const Result<void> file = write_file(call.out / augmented_file, *augmented); !file) return file.error();
    if (const Result<void> traces = results::write_traces(call.out, setup, d.after); !traces) return traces.error();
    return report::write_html(call.out / "report.html", page);
}

/// Settings of the diagnosis. Without --resume, fits kept from an earlier call are removed. Errors: they cannot be.
Result<diagnosis::DiagnoseSettings> diagnose_settings(const DiagnoseCall& call) {
    diagnosis::DiagnoseSettings settings;
    settings.without = call.without;
    settings.search_limit_s = call.search_limit_s;
    // Fits are stored as they finish, so a stopped diagnosis can be resumed.
    settings.fits = call.out / fits_file;
    // Stored fits are reused on request only: they may belong to other settings.
    std::error_code code;
    if (!call.resume) std::filesystem::remove(*settings.fits, code);
    if (code) return Error{"cannot be removed: " + code.message(), settings.fits->string()};
    return settings;
}

/// Opens the experiment, runs checks, diagnoses, checks the result, writes and reports it.
int diagnose_command(const DiagnoseCall& call) {
    Console console(call.work.quiet, call.work.json_progress);
    const Progress progress = console.progress();
    const OpenedExperiment opening = open_command(call, TrialChoice::all, "the declared fit", console, progress);
    if (!opening.setup) return opening.status;
    const setup::Setup& setup = *opening.setup;
    for (const std::string& warning : setup.warnings) console.warn(warning);
    const std::vector<check::Finding> before = check::check_before(setup);
    tell_findings(before, opening.told, console);
    console.print(setup.experiment.name + "\n" + size_line(setup));
    // After open_command(), which holds the lock of the folder: kept fits are removed or read from here on.
    const Result<diagnosis::DiagnoseSettings> settings = diagnose_settings(call);
    if (!settings) return console.refuse(settings.error());
    const double setup_s = opening.stopwatch.seconds();
    // A stopped diagnosis has no verdict, and nothing but its fits is worth keeping.
    const diagnosis::Diagnosis d = diagnosis::whole_diagnosis(setup, *settings, progress);
    if (d.stopped) {
        console.complain("stopped; what was fitted is kept in " + call.out.string() + ", --resume continues from it");
        return status_stopped;
    }
    if (!d.failure.empty()) {
        console.complain(d.failure);
        return status_failed;
    }
    // Not an essential part: without a proposal the diagnosis is complete.
    const Result<std::optional<planning::Proposal>> found = next_experiment(setup, d, declaration_of(call), progress);
    if (!found) console.warn("no further trial is proposed: " + found.error().text());
    const std::optional<planning::Proposal> next = found ? *found : std::nullopt;
    results::RunFacts facts = run_facts(call, setup_s);
    facts.findings = check::check_after({diagnosis::as_diagnosed(d, setup), &d.after}, before);
    tell_findings(facts.findings, before, console);
    console.print("\n" + results::findings_line(facts.findings) + "\n\n" + candidate_lines(d) + "\n\n" +
                  trial_lines(setup, d) + "\n" + distance_line(d.before, d.after) + "\n\n" + verdict_lines(d) + "\n\n" +
                  cost_lines(d));
    if (next)
        console.print("\n" + planning::proposal_lines(*next, planning::PlanningPolicy().proposal) + "\n" +
                      format_number(next->seconds, 3) + " s");
    // The result is printed already, so that a full disk loses files only.
    if (const Result<void> written = write_results(call, opening.experiment, setup, d, next, facts); !written)
        return console.fail(written.error());
    console.print("report: " + (call.out / "report.html").string());
    return status_done;
}

}  // namespace

std::function<int()> declare_diagnose(CLI::App& app) {
    const auto call = std::make_shared<DiagnoseCall>();
    call->fits = true;
    declare_experiment_call(app, *call);
    call->outputs = [own = call.get()](const experiment::Experiment& experiment) {
        return trace_files_and(*own, experiment,
                               {report_name(experiment) + ".json", "report.json", "report.html", augmented_file,
                                fits_file, planning::signal_file});
    };
    declare_leave_out(app, *call);
    add_named_effects(app, "--without", call->without, "effects to exclude", *call);
    add_positive_number(app, "--time-limit", call->search_limit_s,
                        "end the search after so many seconds, with the verdict of what was found (default: no limit)")
        ->type_name("SECONDS");
    app.add_flag("--resume", call->resume, "continue from the fits kept in DIR by a run that was stopped");
    return [call] { return diagnose_command(*call); };
}

}  // namespace myo::app
