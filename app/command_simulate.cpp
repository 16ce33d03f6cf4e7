#include <algorithm>
#include <cstdio>
#include <memory>

#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "project/finding_output.hpp"
#include "project/output_files.hpp"
#include "project/output_json.hpp"
#include "project/time_step.hpp"
#include "study_command.hpp"

namespace myo {
namespace {

struct SimulateCall : StudyCall {
    bool vtu = false;
};

/// About as many frames as an animation needs.
constexpr int series_frames = 100;

std::string values_line(const Study& study, const StudyValues& values) {
    return "E = " + format_number(1e-3 * values.youngs_modulus_Pa, 5) + " kPa, Poisson's ratio " +
           format_number(study.experiment.material.poissons_ratio, 4) + ", density " + format_number(study.experiment.material.density_kg_m3, 5) +
           " kg/m3, damping " + format_number(1e3 * values.damping_s, 4) + " ms" +
           (study.experiment.material.damping_s ? "" : " (assumed: none is declared)");
}

std::string score_table(const Study& study, const StudyRun& run) {
    std::size_t width = 5;
    for (const TrialScore& score : run.scores) width = std::max(width, score.name.size());
    char line[512];
    std::string text;
    const auto add = [&](const char* name, const char* role, const char* steps, const std::string& rms, const std::string& worst) {
        std::snprintf(line, sizeof line, "%-*s  %-8s  %7s  %9s  %s\n", static_cast<int>(std::min<std::size_t>(width, 120)), name, role, steps, rms.c_str(), worst.c_str());
        text += line;
    };
    add("trial", "role", "steps", "rms [mm]", "worst marker [mm]");
    for (std::size_t t = 0; t < study.trials.size(); ++t) {
        const TrialScore* score = find_score(run, study.trials[t].name);
        if (score == nullptr) continue;
        const auto worst = std::max_element(score->markers.begin(), score->markers.end(),
                                            [](const MarkerScore& a, const MarkerScore& b) { return !(b.rms_m <= a.rms_m) && b.rms_m == b.rms_m; });
        add(score->name.c_str(), score->role == TrialRole::fit ? "fit" : "validate",
            std::to_string(run.predictions[t].trace.times_s.size() - 1).c_str(), in_millimetres(score->rms_m),
            worst != score->markers.end() ? in_millimetres(worst->rms_m) + "  " + worst->name : "");
    }
    text.pop_back();
    return text;
}

Result<void> write_results(const SimulateCall& call, const Study& study, const StudyRun& run, const RunFacts& facts,
                           const Progress& progress) {
    if (run.scores.empty()) return {};
    // The smallest and most valuable first, as everywhere: the disk may fill.
    const Json json = simulate_json(study, run, facts);
    if (const Result<void> written = write_json(call.out / "simulate.json", json); !written) return written.error();
    if (const Result<void> traces = write_traces(call.out, study, run); !traces) return traces.error();
    if (call.vtu)
        if (const Result<void> series = write_series(call.out, study, run, series_frames, progress); !series && !progress.cancelled())
            return series.error();
    return {};
}

int simulate_command(const SimulateCall& call) {
    Console console(call.work.quiet, call.work.json_progress);
    const Progress progress = console.progress();
    StudyOpening opening = open_command(call, TrialChoice::all, "the first trial", console, progress);
    if (!opening.study) return opening.status;
    std::optional<Study>& study = opening.study;
    for (const std::string& warning : study->warnings) console.warn(warning);
    const std::vector<Finding> before = check_before(*study);
    tell_findings(before, opening.told, console);
    const double setup_s = opening.setup.seconds();

    const StudyValues values = with_predicted_levels(*study, declared_values(*study));
    console.print(study->experiment.name + "\n" + size_line(*study) + "\n" + values_line(*study, values));
    const StudyRun run = run_with_chosen_steps(*study, values, progress, call.trial);
    if (!study->integration && !progress.cancelled()) {
        const auto told = static_cast<std::ptrdiff_t>(study->warnings.size());
        check_integration(*study);   // with the steps of the run
        for (auto warning = study->warnings.begin() + told; warning != study->warnings.end(); ++warning)
            console.warn(*warning);
    }
    RunFacts facts = run_facts(call, setup_s);
    facts.findings = check_after({.study = *study, .run = &run, .as_declared = true}, before);
    tell_findings(facts.findings, before, console);
    if (!run.scores.empty()) console.print("\n" + findings_line(facts.findings) + "\n\n" + score_table(*study, run));
    if (const Result<void> written = write_results(call, *study, run, facts, progress); !written)
        return console.fail(written.error());
    const std::string kept = std::to_string(run.scores.size()) + " of " + std::to_string(call.trial.empty() ? study->trials.size() : 1) + " trials complete" +
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

}  // namespace

std::function<int()> declare_simulate(CLI::App& app) {
    const auto call = std::make_shared<SimulateCall>();
    call->step_choice = StepChoice::in_run;
    declare_study_call(app, *call);
    call->outputs = [own = call.get()](const Experiment& experiment) {
        std::vector<std::filesystem::path> files = trace_files_and(*own, experiment, {"simulate.json"});
        if (!own->vtu) return files;
        const std::vector<std::filesystem::path> series = series_files(own->out, experiment, series_frames);
        files.insert(files.end(), series.begin(), series.end());
        return files;
    };
    app.add_option("--trial", call->trial, "run this trial only")->type_name("NAME");
    app.add_flag("--vtu", call->vtu, "write each trial as a series of VTU files as well, with a PVD file that joins them");
    return [call] { return simulate_command(*call); };
}

}  // namespace myo
