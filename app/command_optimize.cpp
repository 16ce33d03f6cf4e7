#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>

#include "base/files.hpp"
#include "base/text.hpp"
#include "calibration/body_design.hpp"
#include "calibration/sought_signals.hpp"
#include "check/catalogue.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "experiment/actuators.hpp"
#include "experiment_command.hpp"
#include "prediction/trial_goals.hpp"
#include "prediction/trial_target.hpp"
#include "results/optimize_output.hpp"
#include "results/optimized_experiment.hpp"

namespace myo::app {
namespace {

/// Parsed call of `myoloop optimize`; empty options have the defaults of OptimizeSettings.
struct OptimizeCall : ExperimentCall {
    // Smoothness in mm per unit of change per second; bounds of a muscle's activation [-].
    std::optional<double> frequency_Hz, smoothness_mm_s, lowest, highest;
    // Piecewise constant signals instead of linear ones.
    bool hold = false;
    bool resume = false;
    std::vector<std::string> seek;  // words of calibration::to_string(); empty: signals
    int max_evaluations = calibration::OptimizeSettings{}.max_evaluations;
    int starts = 1;
};

/// Experiment with what a search found of the body; written if --seek names anything.
constexpr const char* optimized_file = "experiment_optimized.toml";

/// Settings of the search from the options of the call; what is sought is read with the experiment.
calibration::OptimizeSettings settings_of(const OptimizeCall& call) {
    calibration::OptimizeSettings settings;
    settings.frequency_Hz = call.frequency_Hz.value_or(settings.frequency_Hz);
    settings.hold = call.hold;
    if (call.smoothness_mm_s) settings.smoothness_m_s = 1e-3 * *call.smoothness_mm_s;
    settings.lowest = call.lowest;
    settings.highest = call.highest.value_or(settings.highest);
    settings.max_evaluations = call.max_evaluations;
    settings.starts = call.starts;
    settings.seed = call.work.seed.value_or(settings.seed);
    return settings;
}

/// Unit of a signal to follow a number: " Pa", empty of a muscle.
std::string unit_after(const setup::Setup& setup, const inverse::SoughtSignal& signal) {
    const std::string
        unit = experiment::actuators(setup.experiment)[*experiment::find_actuator(setup.experiment, signal.name)].unit;
    return unit.empty() ? "" : " " + unit;
}

/// Median standard deviation of the determined values of a signal, ", ± 0.01 (median)".
std::string deviation_text(const inverse::ActuationDeviations& deviations, Eigen::Index signal,
                           const std::string& unit) {
    if (!deviations.found) return "";
    std::vector<double> known;
    for (const double deviation : deviations.deviations.row(signal))
        if (std::isfinite(deviation)) known.push_back(deviation);
    if (known.empty()) return ", not determined";
    const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
    std::nth_element(known.begin(), middle, known.end());
    return ", ± " + format_number(*middle, 2) + unit + (known.size() > 1 ? " (median)" : "");
}

/// Errors of the markers before and after the search, rms [mm].
std::string marker_lines(const calibration::Optimization& result) {
    char line[256];
    std::snprintf(line, sizeof line, "%-32s %9s  %9s", "marker, rms [mm]", "before", "after");
    std::string text = line;
    const prediction::TrialScore &before = result.before.scores.front(), &after = result.after.scores.front();
    for (std::size_t m = 0; m < after.markers.size(); ++m) {
        std::snprintf(line, sizeof line, "\n%-32.32s %s  %s", after.markers[m].name.c_str(),
                      in_millimetres(before.markers[m].rms_m).c_str(), in_millimetres(after.markers[m].rms_m).c_str());
        text += line;
    }
    std::snprintf(line, sizeof line, "\n%-32s %s  %s", "all", in_millimetres(before.rms_m).c_str(),
                  in_millimetres(after.rms_m).c_str());
    text += line;
    return text;
}

/// Registration that the search found: shift [mm] and rotation vector [degrees].
std::string placement_line(const calibration::Optimization& result) {
    char line[256];
    const Eigen::Vector3d moved = 1e3 * result.fit.best.placement.translation_m,
                          turned = 180.0 / std::numbers::pi * result.fit.best.placement.rotation_rad;
    std::snprintf(line, sizeof line,
                  "\nregistration (sought): moved by (%.3f, %.3f, %.3f) mm, turned by (%.3f, %.3f, %.3f) degrees",
                  moved.x(), moved.y(), moved.z(), turned.x(), turned.y(), turned.z());

    return line;
}

/// rms per marker, ranges of the signals, registration, remaining distance, cost.
std::string result_lines(const setup::Setup& setup, const calibration::Optimization& result) {
    std::string text = marker_lines(result);
    for (const calibration::FoundItem& found : result.found)
        text += "\n" + calibration::readable(found.item) + ": " + found.change;
    for (std::size_t s = 0; s < result.problem.sought.signals.size(); ++s) {
        const auto row = result.fit.values.row(static_cast<Eigen::Index>(s));
        const inverse::SoughtSignal& signal = result.problem.sought.signals[s];
        const std::string unit = unit_after(setup, signal);
        text += "\nsignal " + signal.name + ": ";
        if (result.problem.sought.seek_before)
            // The first value is then the level before the start, see SoughtSignals::seek_before.
            text += "held " + format_number(row(0), 4) + unit + " before t = 0 (sought)\nsignal " + signal.name + ": ";
        text += result.problem.sought.constant
                    ? format_number(row(0), 4)
                    : std::to_string(row.size()) + " values, " + format_number(row.minCoeff(), 4) + " ... " +
                          format_number(row.maxCoeff(), 4);
        text += unit + deviation_text(result.deviations, static_cast<Eigen::Index>(s), unit);
    }
    if (result.problem.placement_bounds) text += placement_line(result);
    if (!result.deviations.found) text += "\nstandard deviations: " + result.deviations.reason;
    if (!result.miss.reached)
        text += result.miss.goals ? "\ngoals not reached"
                                  : "\ntarget not reached: " + format_number(result.miss.noise_levels, 3) +
                                        " times the noise is left";
    // A message of a search that did not converge is printed by end_status().
    if (result.fit.converged() && !result.fit.message.empty()) text += "\n" + result.fit.message;
    return text + "\n\n" + std::to_string(result.fit.log.size()) + " evaluations of the best start, " +
           format_number(result.seconds, 3) + " s, " + std::to_string(setup.body->dofs()) + " DOF, steps of " +
           format_number(1e3 * setup.trials.front().options.h_s, 4) + " ms (--dt " +
           format_number(setup.trials.front().options.h_s, 4) + ")";
}

/// Writes the experiment with what was found of the body, and its masks.
Result<void> write_design(const OptimizeCall& call, const experiment::Experiment& experiment, const setup::Setup& setup,
                          const calibration::Optimization& result, Console& console) {
    if (result.found.empty()) return {};
    if (const Result<void> masks = results::write_masks(call.out, experiment, result.found); !masks)
        return masks.error();
    // Index in the whole experiment: the setup has the one trial only.
    const std::size_t trial = *prediction::find_trial(experiment, setup.trials.front().name);
    std::string skipped;
    const Result<std::string> text = results::optimized_experiment(declaration_of(call), call.out, setup, result, trial,
                                                                   &skipped);
    if (!text) return text.error();
    if (!skipped.empty()) console.warn(skipped);
    if (const Result<void> written = write_file(call.out / optimized_file, *text); !written) return written.error();
    console.print("experiment with this body: " + (call.out / optimized_file).string());
    return {};
}

/// Writes optimize.json, traces and signals, the experiment with the found body, and report.html.
///
/// @param experiment  complete, while `setup` has the searched trial only
Result<void> write_results(const OptimizeCall& call, const experiment::Experiment& experiment,
                           const setup::Setup& setup, const calibration::Optimization& result,
                           const results::RunFacts& facts, Console& console) {
    const report::Json json = results::optimize_json(setup, result, facts);
    if (const Result<void> written = report::write_json(call.out / "optimize.json", json); !written)
        return written.error();
    if (const Result<void> files = results::write_actuation(call.out, setup, result); !files) return files.error();
    if (const Result<void> design = write_design(call, experiment, setup, result, console); !design)
        return design.error();
    return report::write_html(call.out / "report.html", results::optimize_report(setup, result, facts));
}

/// Reports an incomplete search and returns the exit status.
int end_status(const OptimizeCall& call, const calibration::Optimization& result, Console& console) {
    const std::string kept = "; the best values so far are written to " + call.out.string() +
                             ", --resume continues from them";
    if (result.stopped) {
        console.complain("stopped before the search converged" + kept);
        return status_stopped;
    }
    if (result.fit.converged()) return status_done;
    console.complain("the search did not converge: " + result.fit.message + kept);
    return status_failed;
}

/// Signals from which the search starts: passive ones, those held before t = 0, or those of an earlier search.
Result<results::EarlierOptimization> first_signals(const OptimizeCall& call, const setup::Setup& setup,
                                                   const inverse::ActuationProblem& problem) {
    if (call.resume) return results::read_optimization(call.out, setup, problem);
    return results::EarlierOptimization{.values = calibration::first_values(setup, problem.sought)};
}

/// What is sought, in one line, and the size of the model.
std::string search_lines(const setup::Setup& setup, const inverse::ActuationProblem& problem, Eigen::Index values,
                         double frequency_Hz) {
    std::vector<std::string> names;
    for (const inverse::SoughtSignal& signal : problem.sought.signals) names.push_back(signal.name);
    const std::size_t goals = setup.experiment.trials.front().goals.size();
    const std::string towards = goals == 0 ? ""
                                           : ", towards " + std::to_string(goals) + (goals == 1 ? " goal" : " goals");
    std::vector<std::string> parts;
    if (!names.empty())
        parts.push_back(std::to_string(values) + " values of " + join(names) +
                        (problem.sought.constant ? ", held at rest" : " at " + format_number(frequency_Hz) + " Hz"));
    for (const inverse::DesignVariablePointer& variable : problem.design) {
        const Eigen::Index count = variable->declared().size();
        parts.push_back(variable->name() + " (" + std::to_string(count) + (count == 1 ? " value)" : " values)"));
    }
    return setup.experiment.name + ", trial " + setup.trials.front().name + towards + ": " + join(parts, "; ") + "\n" +
           size_line(setup);
}

/// Says why there is no result. Returns the exit status.
int end_without_signals(const calibration::Optimization& result, Console& console) {
    if (result.stopped) return stopped_before(first_evaluation, console);
    console.complain("the trial could not be run: " + result.fit.message +
                     "; a smaller --dt or another mesh (--element, --resolution) may help");
    return status_failed;
}

/// Checks of the result. After a cancellation only those before the search are known.
std::vector<check::Finding> checks_of_signals(const setup::Setup& setup, const calibration::Optimization& result,
                                              const std::vector<check::Finding>& before, Console& console,
                                              const Progress& progress) {
    if (result.stopped) return before;
    // Checks of recordings have nothing to say about goals.
    const setup::Setup checked = prediction::without_goals(setup);
    const prediction::SetupRun run = calibration::run_with_found_signals(checked, result, progress);
    std::vector<check::Finding> findings = check::check_after({checked, &run}, before);
    tell_findings(findings, before, console);
    return findings;
}

/// Opens the trial, searches signals, checks the result, writes and reports it.
int optimize_command(const OptimizeCall& call) {
    Console console(call.work.quiet, call.work.json_progress);
    const Progress progress = console.progress();
    OpenedExperiment opening = open_command(call, TrialChoice::one, first_evaluation, console, progress);
    if (!opening.setup) return opening.status;
    // Before with_goals(), which replaces the recording that some checks look at.
    const std::vector<check::Finding> before = check::check_before(*opening.setup);
    Result<setup::Setup> target = prediction::with_goals(*std::move(opening.setup));
    if (!target) return console.refuse(target.error());
    setup::Setup& setup = *target;
    calibration::OptimizeSettings settings = settings_of(call);
    // Words are known once the experiment is read: muscles and parts have names.
    if (!call.seek.empty()) {
        Result<std::vector<calibration::SoughtItem>> seek = calibration::sought_items(call.seek, setup.experiment);
        if (!seek) return console.refuse({seek.error().what, "--seek"});
        settings.seek = *std::move(seek);
    }
    // Changes the setup: fibres of painted muscles become such as a mask gives. Hence before the problem is set up.
    const Result<calibration::BodyDesign> design = calibration::body_design(setup, settings.seek);
    if (!design) return console.refuse(design.error());
    const Result<inverse::ActuationProblem> problem = calibration::actuation_problem(setup, settings,
                                                                                     design->variables);
    if (!problem) return console.refuse(problem.error());
    // With --resume, signals of other knots or muscles are an error of the call.
    const Result<results::EarlierOptimization> from = first_signals(call, setup, *problem);
    if (!from) return console.refuse(from.error());
    // From here on the call is right: what follows are warnings.
    for (const std::string& note : from->notes) console.warn(note);
    for (const std::string& warning : setup.warnings) console.warn(warning);
    if (!setup.experiment.sensors.empty())
        console.warn("the readings of sensors take no part in the search for signals; calibrate fits them");
    tell_findings(before, opening.told, console);
    console.print(search_lines(setup, *problem, from->values.size(), settings.frequency_Hz));
    const double setup_s = opening.stopwatch.seconds();
    calibration::Optimization result = calibration::optimize_with_chosen_steps(setup, *problem, settings,
                                                                               {from->values, from->design}, progress);
    // Earlier evaluations count, so that the file shows the total cost.
    result.earlier_evaluations += from->evaluations;
    if (!result.usable()) return end_without_signals(result, console);
    result.found = calibration::found_items(setup, *design, result.fit.design);
    for (const std::string& warning : result.warnings) console.warn(warning);
    results::RunFacts facts = run_facts(call, setup_s);
    facts.findings = checks_of_signals(setup, result, before, console, progress);
    console.print("\n" + result_lines(setup, result));
    if (const Result<void> written = write_results(call, opening.experiment, setup, result, facts, console); !written)
        return console.fail(written.error());
    console.print("report: " + (call.out / "report.html").string());
    return end_status(call, result, console);
}

/// Files that the command may write, for ExperimentCall::outputs.
std::vector<std::filesystem::path> optimize_files(const OptimizeCall& call, const experiment::Experiment& experiment) {
    std::vector<std::filesystem::path> files = trace_files_and(call, experiment, {"optimize.json", "report.html"});
    const std::vector<std::filesystem::path> signals = results::actuation_files(call.out, experiment);
    files.insert(files.end(), signals.begin(), signals.end());
    // Words that name nothing are refused before anything is written.
    if (const auto seek = calibration::sought_items(call.seek, experiment)) {
        for (const std::filesystem::path& mask : results::mask_files(experiment, *seek))
            files.push_back(call.out / mask);
        if (!seek->empty()) files.push_back(call.out / optimized_file);
    }
    return files;
}

/// Value of --smoothness; 0 is allowed and switches the term off. Throws CLI::ValidationError.
void read_smoothness(const std::string& text, OptimizeCall& call) {
    double value = 0.0;
    if (!parse_number(text, value) || !std::isfinite(value) || value < 0.0)
        throw CLI::ValidationError("--smoothness", "'" + text + "' is not a number from 0 on");
    call.smoothness_mm_s = value;
}

}  // namespace

std::function<int()> declare_optimize(CLI::App& app) {
    const auto call = std::make_shared<OptimizeCall>();
    // The search itself shortens the step if its signals require it.
    call->step_choice = StepChoice::half_interval;
    declare_experiment_call(app, *call);
    call->outputs = [own = call.get()](const experiment::Experiment& experiment) {
        return optimize_files(*own, experiment);
    };
    app.add_option("--trial", call->trial,
                   "trial whose goals, or else trace, are the target (default: the first with role fit)")
        ->type_name("NAME");
    // Read as words here: their names are known once the experiment is read.
    app.add_option("--seek", call->seek,
                   "what may change, separated by commas: signals (of all that are not declared with sought = false), "
                   "signals:ACTUATOR, direction:MUSCLE (its fibres), weights:MUSCLE (its paint), modulus, modulus:PART "
                   "(default: signals)")
        ->delimiter(',')
        ->type_name("LIST");
    add_positive_number(app, "--frequency", call->frequency_Hz, "values of each signal per second (default: 20)")
        ->type_name("HZ");
    app.add_flag("--hold", call->hold, "hold each value until the next instead of going there in a straight line");
    app.add_option_function<std::string>(
           "--smoothness", [call](const std::string& text) { read_smoothness(text, *call); },
           "so many millimetres of rms error a change by 1 (muscle), or by three times its limit, per second is worth "
           "(default: the noise of the markers)")
        ->type_name("MM");
    add_optional_number(app, "--lowest", call->lowest,
                        "lowest activation of any muscle (default: that of [limits], else 0.5)");
    add_optional_number(app, "--highest", call->highest, "highest activation of any muscle (default: 2)");
    add_count(app, "--max-evaluations", call->max_evaluations, "runs with their gradient, at most (default: 100)");
    add_count(app, "--starts", call->starts,
              "searches: the first from where the signals rest, the others from random levels (--seed)");
    app.add_flag("--resume", call->resume, "continue from the optimize.json in DIR");
    return [call] { return optimize_command(*call); };
}

}  // namespace myo::app
