#include <algorithm>
#include <memory>

#include "base/files.hpp"
#include "base/text.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment_command.hpp"
#include "next_experiment.hpp"
#include "planning/proposal_output.hpp"
#include "planning/reported_rivals.hpp"
#include "toml/toml_text.hpp"

namespace myo::app {
namespace {

/// What an early cancellation prevents, for stopped_before().
const char* const first_proposal = "a trial was proposed";
const char* const proposal_json_file = "proposal.json";
const char* const proposal_page_file = "proposal.html";
const char* const trial_file = "next_trial.toml";
/// Word of --between for the declared model, without effects.
const char* const declared_word = "none";

/// Parsed call of `myoloop propose`.
struct ProposeCall : ExperimentCall {
    // As given, one set per option.
    std::vector<std::string> between;
    std::vector<std::string> between_ids;  // all that they name
    // JSON report of a finished diagnosis, instead of --between; empty: none.
    std::filesystem::path report;
    // Limits of --limits; each replaces that of the experiment.
    experiment::LimitsDeclaration limits;
    // rms error of predictions by mesh and step; empty: from the noise.
    std::optional<double> numerical_error_m;
};

/// Where the values of LimitsDeclaration are given, by the keys of [limits].
std::vector<std::pair<std::string, std::optional<double>*>> limit_keys(experiment::LimitsDeclaration& limits) {
    return {{"force_N", &limits.force_N},           {"mass_kg", &limits.mass_kg},
            {"pressure_Pa", &limits.pressure_Pa},   {"tension_N", &limits.tension_N},
            {"shortening_m", &limits.shortening_m}, {"activation", &limits.activation},
            {"duration_s", &limits.duration_s}};
}

/// Limits out of "force_N=0.5,duration_s=3"; throws CLI::ValidationError for an unknown key or a value that is not
/// positive.
void read_limits(const std::string& text, experiment::LimitsDeclaration& limits) {
    const auto keys = limit_keys(limits);
    std::vector<std::string> names;
    for (const auto& [name, value] : keys) names.push_back(name);
    for (const std::string& word : split_words(text)) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const auto key = std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.first == name; });
        if (key == keys.end()) throw CLI::ValidationError("--limits", unknown_word(name, names));
        double value = 0.0;
        if (equals == std::string::npos || !parse_number(word.substr(equals + 1), value) || !(value > 0.0))
            throw CLI::ValidationError("--limits", "'" + word + "' must be " + name + "= and a positive number");
        if (name == "activation" && value >= 1.0)
            throw CLI::ValidationError("--limits", "activation must lie between 0 and 1, which is passive");
        *key->second = value;
    }
}

/// Effects of one --between; `none` is the declared model.
std::vector<std::string> read_set(const std::string& text) {
    if (text == declared_word) return {};
    std::vector<std::string> ids = split_words(text);
    for (const std::string& id : ids)
        if (std::count(ids.begin(), ids.end(), id) > 1)
            throw CLI::ValidationError("--between", "'" + text + "' names " + id + " twice");
    return ids;
}

/// The two sets of effects of a call, to be fitted or, from a report, with fitted values.
///
/// Errors: neither or both of --between and --report; not two different sets; those of planning::reported_rivals().
Result<std::array<planning::RivalStart, 2>> starts_of(const ProposeCall& call) {
    if (call.between.empty() == call.report.empty())
        return Error{"give either two sets of effects, or --report with the report of a diagnosis", "--between"};
    if (!call.report.empty()) {
        // Laws of the experiment may be effects of the report. An experiment that cannot be read is reported later.
        const Result<experiment::Experiment> declared = experiment::read_experiment(call.experiment,
                                                                                    call.setup.overrides);
        return planning::reported_rivals(call.report, declared ? declared->laws : effect::Laws());
    }
    if (call.between.size() != 2) return Error{"must be given twice, once for each set of effects", "--between"};
    std::array<planning::RivalStart, 2> starts{planning::RivalStart{read_set(call.between[0])},
                                               planning::RivalStart{read_set(call.between[1])}};
    // The order of a set has no meaning.
    std::array<std::vector<std::string>, 2> sorted{starts[0].ids, starts[1].ids};
    for (std::vector<std::string>& ids : sorted) std::sort(ids.begin(), ids.end());
    if (sorted[0] == sorted[1]) return Error{"both sets are the same", "--between"};
    return starts;
}

/// Writes proposal.json, the trial as TOML with its signal, and proposal.html into the folder of --out, if there is
/// one.
Result<void> write_proposal(const ProposeCall& call, const planning::Proposal& proposal,
                            const experiment::Experiment& experiment, const results::RunFacts& facts) {
    if (call.out.empty()) return {};
    const std::string folder = std::filesystem::weakly_canonical(experiment.folder).filename().string();
    if (const Result<void> json = report::write_json(call.out / proposal_json_file,
                                                     planning::proposal_json(proposal, folder, facts));
        !json)
        return json;
    if (const planning::RatedTrial* const best = proposal.best())
        if (const Result<void> text = write_file(call.out / trial_file, planning::trial_text(best->trial)); !text)
            return text;
    if (const Result<void> signal = write_signal(call.out, proposal); !signal) return signal;
    report::HtmlReport page{.title = experiment.name + ": the next experiment"};
    page.sections.push_back(planning::proposal_section(proposal, planning::PlanningPolicy().proposal));
    page.footer = "myoloop " + facts.version + ", " + join(facts.command, " ");
    return report::write_html(call.out / proposal_page_file, page);
}

/// Opens the experiment, fits both sets, rates trials, prints and writes the best.
int propose_command(ProposeCall& call) {
    Console console(call.work.quiet, call.work.json_progress);
    const Progress progress = console.progress();
    call.writes_folder = !call.out.empty();
    // Before the experiment is prepared: a wrong call is refused at once.
    const Result<std::array<planning::RivalStart, 2>> starts = starts_of(call);
    if (!starts) return console.refuse(starts.error());
    const OpenedExperiment opening = open_command(call, TrialChoice::all, first_proposal, console, progress);
    if (!opening.setup) return opening.status;
    for (const std::string& warning : opening.setup->warnings) console.warn(warning);
    console.print(opening.setup->experiment.name + "\n" + size_line(*opening.setup));
    const double setup_s = opening.stopwatch.seconds();
    const Result<planning::FittedRivals> fitted = planning::fitted_rivals(*opening.setup, *starts, progress);
    if (progress.cancelled()) return stopped_before(first_proposal, console);
    const auto failed = [&](const Error& error) {
        console.complain(with_options(error.text()));
        return static_cast<int>(status_failed);
    };
    if (!fitted) return failed(fitted.error());
    for (std::size_t i = 0; i < 2; ++i)
        console.print(
            planning::rival_words(fitted->rivals[i].ids) + ": fitted to " + format_number(1e3 * fitted->rms_m[i], 3) +
            " mm rms, noise " + format_number(1e3 * setup::mean_noise(fitted->setup), 3) + " mm" +
            (fitted->made_motion ? "; nothing is recorded, so the motion is that of the first with typical values"
                                 : ""));
    // Trials are tried as tables appended to this text.
    const Result<std::string> declaration = read_file(declaration_of(call));
    if (!declaration) return console.refuse(declaration.error());
    const double fits_s = opening.stopwatch.seconds() - setup_s;
    const planning::PlanningPolicy policy;
    const Result<planning::Proposal> proposal = planning::propose_trial({fitted->setup,
                                                                         fitted->rivals,
                                                                         *declaration,
                                                                         declaration_of(call),
                                                                         call.limits,
                                                                         call.numerical_error_m,
                                                                         {},
                                                                         policy},
                                                                        progress);
    if (progress.cancelled()) return stopped_before(first_proposal, console);
    if (!proposal) return failed(proposal.error());
    console.print("\n" + planning::proposal_lines(*proposal, policy.proposal) + "\n\ntime: setup " +
                  format_number(setup_s, 3) + " s, fits " + format_number(fits_s, 3) + " s, " +
                  std::to_string(proposal->runs) + " runs " + format_number(proposal->seconds, 3) + " s");
    if (const Result<void> written = write_proposal(call, *proposal, opening.experiment, run_facts(call, setup_s));
        !written)
        return console.fail(written.error());
    if (!call.out.empty()) console.print("trial: " + (call.out / trial_file).string());
    // Without a trial that can be run there is nothing to do with the output.
    return proposal->best() ? status_done : status_failed;
}

}  // namespace

std::function<int()> declare_propose(CLI::App& app) {
    const auto call = std::make_shared<ProposeCall>();
    declare_experiment_call(app, *call);
    // open_command() checks the names, which may be laws of the experiment.
    call->named_effects.emplace_back("--between", &call->between_ids);
    call->outputs = [own = call.get()](const experiment::Experiment&) {
        std::vector<std::filesystem::path> files;
        if (!own->out.empty())
            for (const char* file : {proposal_json_file, proposal_page_file, trial_file, planning::signal_file})
                files.push_back(own->out / file);
        return files;
    };
    app.add_option_function<std::vector<std::string>>(
           "--between",
           [call](const std::vector<std::string>& sets) {
               for (const std::string& set : sets)
                   for (std::string& id : read_set(set)) call->between_ids.push_back(std::move(id));
               call->between = sets;
           },
           "a set of effects, or none for the declared model; given twice")
        ->type_name("A,B")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--report", call->report, "instead: report of a finished diagnosis of this experiment")
        ->type_name("FILE");
    app.add_option_function<std::string>(
           "--limits", [call](const std::string& text) { read_limits(text, call->limits); },
           "most that the trial may use, with the keys of [limits]")
        ->type_name("KEY=VALUE,...");
    add_positive_number(app, "--numerical-error", call->numerical_error_m,
                        "rms error of the predictions by mesh and step in m (default: from the noise)");
    return [call] { return propose_command(*call); };
}

}  // namespace myo::app
