#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "experiment_command.hpp"
#include "material/catalogue.hpp"
#include "results/calibration_report.hpp"
#include "results/finding_output.hpp"
#include "results/marker_places.hpp"
#include "results/output_files.hpp"

namespace myo::app {
namespace {

/// Parsed call of `myoloop calibrate`.
struct CalibrateCall : ExperimentCall {
    std::vector<std::string> parameters;  // material parameters to fit; empty: material.calibrate
    // Continues from the calibrate.json in the output folder.
    bool resume = false;
    int starts = 1;  // number of starts of the fit
};

/// Names that --parameters accepts; those of another law fit nothing.
std::vector<std::string> material_parameters() {
    std::vector<std::string> names{"youngs_modulus", "damping"};
    for (const material::LawParameter& parameter : material::all_law_parameters()) names.push_back(parameter.name);
    return names;
}

/// Parts of the standard deviation that are known, in the unit of the parameter: "noise 0.0004, mesh 0.011, step 0.001;
/// "; empty if only the noise is.
std::string deviation_parts(const calibration::Calibration& calibration, Eigen::Index row) {
    const calibration::NumericalDeviations& numerical = calibration.numerical;
    if (!(calibration.fit.deviations(row) > 0.0) || (numerical.mesh.size() == 0 && numerical.step.size() == 0))
        return {};
    std::string text = "noise " + format_number(calibration.fit.deviations(row), 2);
    if (numerical.mesh.size() > 0) text += ", mesh " + format_number(numerical.mesh(row), 2);
    if (numerical.step.size() > 0) text += ", step " + format_number(numerical.step(row), 2);
    return text + "; ";
}

/// Fitted parameters with standard deviations and start values, one per line.
std::string parameter_lines(const calibration::Calibration& calibration) {
    std::string text;
    char line[256];
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const prediction::ModelParameter& p = calibration.parameters[i];
        const double deviation = calibration.deviation(i);
        std::string spread = std::isfinite(deviation) ? "± " + format_number(deviation, 3) : "not determined";
        if (std::isfinite(deviation))
            spread.resize(std::max<std::size_t>(spread.size(), 15), ' ');  // ± has two bytes in UTF-8
        std::snprintf(line, sizeof line, "%s%-34s %12.6g %-14s %s (%sstart %.6g)", i > 0 ? "\n" : "",
                      p.parameter.name.c_str(), calibration.fit.values(row), spread.c_str(), p.unit.c_str(),
                      deviation_parts(calibration, row).c_str(), calibration.fit.start(row));
        text += line;
    }
    return text;
}

/// Outcome of each start, if there are several; else empty.
std::string start_lines(const calibration::Calibration& calibration) {
    std::string text;
    if (calibration.starts.size() < 2) return text;
    for (std::size_t s = 0; s < calibration.starts.size(); ++s) {
        const calibration::CalibrationStart& start = calibration.starts[s];
        // Words of the result file, here with blanks.
        std::string ended = results::ending_word(start.status);
        std::replace(ended.begin(), ended.end(), '_', ' ');
        text += "\nstart " + std::to_string(s + 1) + ": " + ended + ", cost " + format_number(start.cost_before, 5) +
                " to " + format_number(start.cost_after, 5) + ", " + std::to_string(start.history.size()) +
                " evaluations;";
        for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            text += (i > 0 ? ", " : " ") + calibration.parameters[i].parameter.name + " " +
                    format_number(start.start(row), 4) + " to " + format_number(start.values(row), 5);
        }
    }
    return text + "\n";
}

/// rms per trial before and after the fit [mm], "-" for a trial that did not complete, and the errors of sensors.
std::string trial_lines(const setup::Setup& setup, const calibration::Calibration& calibration) {
    std::size_t width = 5;
    for (const setup::PreparedTrial& trial : setup.trials) width = std::max(width, trial.name.size());
    // A longer name would not fit the buffer of a line.
    const int column = static_cast<int>(std::min<std::size_t>(width, 120));
    char line[512];
    std::snprintf(line, sizeof line, "%-*s  %-9s  %9s  %9s", column, "rms [mm]", "", "before", "after");
    std::string text = line;
    const auto shown = [](const prediction::TrialScore* score) {
        return in_millimetres(score != nullptr ? score->rms_m : std::nan(""));
    };
    for (const setup::PreparedTrial& trial : setup.trials) {
        std::snprintf(line, sizeof line, "\n%-*s  %-9s  %s  %s", column, trial.name.c_str(),
                      result_word(trial.role).c_str(),
                      shown(results::find_score(calibration.before, trial.name)).c_str(),
                      shown(results::find_score(calibration.after, trial.name)).c_str());
        text += line;
    }
    return text + results::sensor_lines(calibration.before, "before") +
           results::sensor_lines(calibration.after, "after");
}

/// Writes calibrate.json, traces and report.html.
Result<void> write_results(const CalibrateCall& call, const setup::Setup& setup,
                           const calibration::Calibration& calibration, const results::RunFacts& facts) {
    // The file that --resume reads comes first: the disk may become full.
    const report::Json json = results::calibrate_json(setup, calibration, facts);
    if (const Result<void> written = report::write_json(call.out / "calibrate.json", json); !written)
        return written.error();
    if (const Result<void> traces = results::write_traces(call.out, setup, calibration.after); !traces)
        return traces.error();
    return report::write_html(call.out / "report.html", results::calibration_report(setup, calibration, facts));
}

/// Reports incomplete results and returns the exit status.
int end_status(const CalibrateCall& call, const calibration::Calibration& calibration, Console& console) {
    const std::string restart = " written to " + call.out.string() + ", --resume continues from them";
    if (calibration.stopped) {
        console.complain(calibration.fit.converged()
                             ? "stopped before all trials were predicted; the fitted values are written to " +
                                   call.out.string()
                             : "stopped before the fit converged; the best values so far are" + restart);
        return status_stopped;
    }
    if (!calibration.fit.converged()) {
        console.complain("the fit did not converge: " + calibration.fit.message + "; the best values so far are" +
                         restart);
        return status_failed;
    }
    if (calibration.after.ok()) return status_done;
    console.complain("the fit converged, but with its values " + with_options(calibration.after.failure));
    return status_failed;
}

/// An error if the declaration leaves nothing to fit; known before any simulation.
Result<void> check_unknowns(const CalibrateCall& call, const setup::Setup& setup) {
    if (!prediction::free_parameters(setup, call.parameters).empty()) return {};
    return Error{
        "nothing is left to fit: material.calibrate names nothing that is not exact, and nothing else is unknown; "
        "name what to fit with --parameters, or give it a tolerance above 0",
        call.experiment.string()};
}

/// The calibration that --resume continues; without --resume an empty one.
Result<calibration::EarlierCalibration> earlier_calibration(const CalibrateCall& call, const setup::Setup& setup,
                                                            const calibration::CalibrationSettings& settings) {
    if (call.resume) return calibration::read_calibration(call.out, setup, settings);
    return calibration::EarlierCalibration{};
}

/// Says why there is no result. Returns the exit status.
int end_without_fit(const calibration::Calibration& calibration, Console& console) {
    if (calibration.stopped) return stopped_before(first_evaluation, console);
    console.complain("the fit failed: " + with_options(calibration.fit.message) +
                     "; a start nearer the truth (--set material.youngs_modulus_Pa=...) may help");
    return status_failed;
}

/// Findings of the checks, values, errors of the trials, and starts.
std::string calibration_lines(const setup::Setup& setup, const calibration::Calibration& calibration,
                              const results::RunFacts& facts) {
    return "\n" + results::findings_line(facts.findings) + "\n\n" + parameter_lines(calibration) + "\n\n" +
           trial_lines(setup, calibration) + "\n" + results::place_lines(calibration.places) +
           distance_line(calibration.before, calibration.after) + "\n" + start_lines(calibration);
}

/// Number of evaluations and wall-clock time of the fit, and where the report is.
std::string cost_line(const CalibrateCall& call, const calibration::Calibration& calibration) {
    return std::to_string(calibration.evaluations()) +
           (calibration.evaluations() == 1 ? " evaluation, " : " evaluations, ") +
           format_number(calibration.seconds, 3) + " s; report: " + (call.out / "report.html").string();
}

/// Opens the experiment, runs checks, fits, checks the result, writes and reports it.
int calibrate_command(const CalibrateCall& call) {
    Console console(call.work.quiet, call.work.json_progress);
    const Progress progress = console.progress();
    OpenedExperiment opening = open_command(call, TrialChoice::all, first_evaluation, console, progress);
    if (!opening.setup) return opening.status;
    std::optional<setup::Setup>& setup = opening.setup;
    // Errors of the call come before the first simulation.
    if (const Result<void> unknown = check_unknowns(call, *setup); !unknown) return console.refuse(unknown.error());
    calibration::CalibrationSettings settings{call.parameters, {}, call.starts, call.work.seed.value_or(1)};
    const Result<calibration::EarlierCalibration> earlier = earlier_calibration(call, *setup, settings);
    if (!earlier) return console.refuse(earlier.error());
    for (const std::string& note : earlier->notes) console.warn(note);
    // The other starts, if there are any, stay random.
    if (call.resume) settings.from = earlier->values;
    for (const std::string& warning : setup->warnings) console.warn(warning);
    // Checks run before the fit, so that a user can stop a long fit that cannot succeed.
    const std::vector<check::Finding> before = check::check_before(*setup);
    tell_findings(before, opening.told, console);
    const double setup_s = opening.stopwatch.seconds();
    console.print(setup->experiment.name + "\n" + size_line(*setup));
    calibration::Calibration calibration = calibration::calibrate_with_chosen_steps(*setup, settings, progress);
    calibration.earlier_evaluations += earlier->evaluations;  // they count, so that the file shows the total cost
    if (!calibration.usable()) return end_without_fit(calibration, console);
    for (const std::string& warning : calibration.warnings) console.warn(warning);
    results::RunFacts facts = run_facts(call, setup_s);
    // Includes the findings before the fit; only new ones are printed.
    facts.findings = check::check_after({*setup, &calibration.after, &calibration}, before);
    tell_findings(facts.findings, before, console);
    console.print(calibration_lines(*setup, calibration, facts));
    if (const Result<void> written = write_results(call, *setup, calibration, facts); !written)
        return console.fail(written.error());
    console.print(cost_line(call, calibration));
    return end_status(call, calibration, console);
}

}  // namespace

std::function<int()> declare_calibrate(CLI::App& app) {
    const auto call = std::make_shared<CalibrateCall>();
    // Makes open_command() require a trial of role fit.
    call->fits = true;
    declare_experiment_call(app, *call);
    // Known before the run, so that inputs are never overwritten. A plain pointer, because the call holds this
    // function: a shared one would never be released.
    call->outputs = [own = call.get()](const experiment::Experiment& experiment) {
        return trace_files_and(*own, experiment, {"calibrate.json", "report.html"});
    };
    app.add_option_function<std::string>(
           "--parameters",
           [call](const std::string& text) {
               // Names are known without an experiment, so a misspelt one ends the parsing.
               call->parameters = split_words(text);
               const std::vector<std::string> known = material_parameters();
               for (const std::string& name : call->parameters)
                   if (std::find(known.begin(), known.end(), name) == known.end())
                       throw CLI::ValidationError("--parameters", unknown_word(name, known));
           },
           "material parameters to fit, instead of material.calibrate: " + join(material_parameters(), ","))
        ->type_name("A,B");
    declare_leave_out(app, *call);
    add_count(
        app, "--starts", call->starts,
        "fits: the first from the declared values, the others from random ones around them (--seed); the best is kept");
    app.add_flag("--resume", call->resume, "continue from the calibrate.json in DIR");
    return [call] { return calibrate_command(*call); };
}

}  // namespace myo::app
