#include <algorithm>
#include <cstdio>
#include <memory>

#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "experiment_command.hpp"
#include "prediction/time_step.hpp"
#include "results/finding_output.hpp"
#include "results/output_files.hpp"
#include "results/output_json.hpp"

namespace myo::app {
namespace {

/// Parsed call of `myoloop simulate`.
struct SimulateCall : ExperimentCall {
    bool vtu = false;  // also writes VTU series
};

/// Frames per trial, sufficient for an animation.
constexpr int series_frames = 100;

/// Material values of the run; an assumed damping is marked.
std::string values_line(const setup::Setup& setup, const prediction::ParameterValues& values) {
    return "E = " + format_number(1e-3 * values.youngs_modulus_Pa, 5) + " kPa, Poisson's ratio " +
           format_number(setup.experiment.material.poissons_ratio, 4) + ", density " +
           format_number(setup.experiment.material.density_kg_m3, 5) + " kg/m3, damping " +
           format_number(1e3 * values.damping_s, 4) + " ms" +
           (setup.experiment.material.damping_s ? "" : " (assumed: none is declared)");
}

/// rms per trial with the worst marker.
std::string score_table(const setup::Setup& setup, const prediction::SetupRun& run) {
    std::size_t width = 5;
    for (const prediction::TrialScore& score : run.scores) width = std::max(width, score.name.size());
    char line[512];
    std::string text;
    const auto add = [&](const char* name, const char* role, const char* steps, const std::string& rms,
                         const std::string& worst) {
        std::snprintf(line, sizeof line, "%-*s  %-8s  %7s  %9s  %s\n",
                      static_cast<int>(std::min<std::size_t>(width, 120)), name, role, steps, rms.c_str(),
                      worst.c_str());
        text += line;
    };
    add("trial", "role", "steps", "rms [mm]", "worst marker [mm]");
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const prediction::TrialScore* score = results::find_score(run, setup.trials[t].name);
        if (score == nullptr) continue;
        const auto worst = std::max_element(score->markers.begin(), score->markers.end(),
                                            [](const prediction::MarkerScore& a, const prediction::MarkerScore& b) {
                                                // A NaN, of a marker that was never seen, is less than every number.
                                                return !(b.rms_m <= a.rms_m) && b.rms_m == b.rms_m;
                                            });
        add(score->name.c_str(), to_string(score->role).c_str(),
            std::to_string(run.predictions[t].trace.times_s.size() - 1).c_str(), in_millimetres(score->rms_m),
            worst != score->markers.end() ? in_millimetres(worst->rms_m) + "  " + worst->name : "");
    }
    // The line break of the last row.
    text.pop_back();
    return text + results::sensor_lines(run);
}

/// Writes simulate.json, traces and optional VTU series.
Result<void> write_results(const SimulateCall& call, const setup::Setup& setup, const prediction::SetupRun& run,
                           const results::RunFacts& facts, const Progress& progress) {
    // Without a complete trial nothing is written, and end_simulation() gives the reason.
    if (run.scores.empty()) return {};
    // The smallest and most valuable file first, as in all commands: the disk may become full.
    const report::Json json = results::simulate_json(setup, run, facts);
    if (const Result<void> written = report::write_json(call.out / "simulate.json", json); !written)
        return written.error();
    if (const Result<void> traces = results::write_traces(call.out, setup, run); !traces) return traces.error();
    if (call.vtu)
        if (const Result<void> series = results::write_series(call.out, setup, run, series_frames, progress);
            !series && !progress.cancelled())
            return series.error();
    return {};
}

/// The run may have chosen shorter steps, so the integration is checked afterwards; only new warnings are printed.
void report_integration(setup::Setup& setup, Console& console) {
    const auto told = static_cast<std::ptrdiff_t>(setup.warnings.size());
    setup::check_integration(setup);  // with the steps of the run
    for (auto warning = setup.warnings.begin() + told; warning != setup.warnings.end(); ++warning)
        console.warn(*warning);
}

/// Says how the runs ended. Returns the exit status.
int end_simulation(const SimulateCall& call, const setup::Setup& setup, const prediction::SetupRun& run,
                   const Progress& progress, Console& console) {
    const std::string kept = std::to_string(run.scores.size()) + " of " +
                             std::to_string(call.trial.empty() ? setup.trials.size() : 1) + " trials complete" +
                             (run.scores.empty() ? "; nothing was written" : "; written to " + call.out.string());
    if (progress.cancelled()) {
        console.complain("stopped; " + kept);
        return status_stopped;
    }
    if (!run.ok()) {
        console.complain(with_options(run.failure) + "; " + kept);
        return status_failed;
    }
    console.print("\n" + format_number(run.seconds, 3) + " s; written to " + call.out.string());
    return status_done;
}

/// Opens the experiment, runs checks and trials, prints scores and writes results.
int simulate_command(const SimulateCall& call) {
    Console console(call.work.quiet, call.work.json_progress);
    const Progress progress = console.progress();
    OpenedExperiment opening = open_command(call, TrialChoice::all, "the first trial", console, progress);
    if (!opening.setup) return opening.status;
    std::optional<setup::Setup>& setup = opening.setup;
    for (const std::string& warning : setup->warnings) console.warn(warning);
    const std::vector<check::Finding> before = check::check_before(*setup);
    tell_findings(before, opening.told, console);
    const double setup_s = opening.stopwatch.seconds();

    // Nothing is fitted: free levels have their declared values.
    const prediction::ParameterValues values = prediction::with_predicted_levels(*setup,
                                                                                 prediction::declared_values(*setup));
    console.print(setup->experiment.name + "\n" + size_line(*setup) + "\n" + values_line(*setup, values));
    const prediction::SetupRun run = prediction::run_with_chosen_steps(*setup, values, progress, call.trial);
    // open_command() has checked the integration already unless the run chooses its steps.
    if (!setup->integration && !progress.cancelled()) report_integration(*setup, console);
    results::RunFacts facts = run_facts(call, setup_s);
    facts.findings = check::check_after({.setup = *setup, .run = &run, .as_declared = true}, before);
    tell_findings(facts.findings, before, console);
    if (!run.scores.empty())
        console.print("\n" + results::findings_line(facts.findings) + "\n\n" + score_table(*setup, run));
    if (const Result<void> written = write_results(call, *setup, run, facts, progress); !written)
        return console.fail(written.error());
    return end_simulation(call, *setup, run, progress, console);
}

}  // namespace

std::function<int()> declare_simulate(CLI::App& app) {
    const auto call = std::make_shared<SimulateCall>();
    call->step_choice = StepChoice::in_run;
    declare_experiment_call(app, *call);
    call->outputs = [own = call.get()](const experiment::Experiment& experiment) {
        std::vector<std::filesystem::path> files = trace_files_and(*own, experiment, {"simulate.json"});
        if (!own->vtu) return files;
        const std::vector<std::filesystem::path> series = results::series_files(own->out, experiment, series_frames);
        files.insert(files.end(), series.begin(), series.end());
        return files;
    };
    app.add_option("--trial", call->trial, "run this trial only")->type_name("NAME");
    app.add_flag("--vtu", call->vtu,
                 "write each trial as a series of VTU files as well, with a PVD file that joins them");
    return [call] { return simulate_command(*call); };
}

}  // namespace myo::app
