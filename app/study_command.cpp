#include "study_command.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/overwrites.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "check/declared_steps.hpp"
#include "commands.hpp"
#include "dynamics/run_advice.hpp"
#include "exit_status.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/quality.hpp"
#include "project/check_body.hpp"
#include "project/finding_output.hpp"
#include "project/mesh_words.hpp"
#include "project/output_files.hpp"
#include "project/read_experiment.hpp"
#include "project/study_target.hpp"
#include "project/time_step.hpp"
#include "project/untested_fit.hpp"

namespace myo {
namespace {

double physical_memory_bytes() { return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGE_SIZE)); }

Result<void> check_resolution(const StudyCall& call, const Experiment& experiment) {
    if (!call.study.settings.mesh.resolution_m) return {};
    const Result<SurfaceMesh> surface = read_body_surface(experiment);
    if (!surface) return {};   // prepare_study() says what is wrong with it
    const ElementKind element = call.study.settings.mesh.element.value_or(automatic_element(*surface));
    const double edge = *call.study.settings.mesh.resolution_m;
    const CountEstimate estimate = estimate_counts(*surface, cell_type(element), edge);
    if (!(estimate.cells > most_grid_cells)) return {};
    return Error{"an edge length of " + format_number(edge) + " m would make about " + format_number(estimate.cells, 2) + " elements; the limit is 2 million",
                 "--resolution"};
}

Result<void> check_steps(const Study& study) {
    double bytes = 0.0, steps = 0.0;
    for (const StudyTrial& trial : study.trials) {
        const double own = trial.options.end_s / trial.options.h_s;
        steps += own;
        bytes += own * static_cast<double>(study.mesh.mesh.node_count()) * 6.0 * sizeof(double);
    }
    if (bytes < 0.7 * physical_memory_bytes()) return {};
    return Error{"the trials would take " + format_number(steps, 2) + " steps, whose states need " + format_number(1e-9 * bytes, 2) +
                     " GB of memory; choose a larger step or a coarser mesh",
                 "--dt"};
}

/// Reads the experiment and makes sure that results can be written, by this run alone; nothing long yet.
Result<Experiment> open_experiment(const StudyCall& call, std::optional<FolderLock>& lock) {
    if (call.experiment.empty()) return Error{"name an experiment folder", ""};
    if (call.writes_folder && call.out.empty()) return Error{"name a folder for the results", "--out"};
    if (call.study.spectral_radius && call.study.settings.integrator != Integrator::generalized_alpha)
        return Error{"only --integrator " + to_string(Integrator::generalized_alpha) + " has one to choose", "--spectral-radius"};
    Result<Experiment> experiment = read_experiment(call.experiment, call.study.overrides);
    if (!experiment) return experiment;
    const Result<void> kept = check_overwrites(call.writes_folder ? "--out" : "--json", call.outputs(*experiment),
                                               files_read(call.experiment, *experiment));
    if (!kept) return kept.error();
    if (!call.writes_folder) return experiment;
    if (const Result<void> folder = prepare_output_folder(call.out); !folder)
        return Error{folder.error().text(), "--out"};
    Result<FolderLock> taken = FolderLock::take(call.out);
    if (!taken) return Error{taken.error().text(), "--out"};
    lock = std::move(*taken);
    return experiment;
}

/// prepare_study() with limits that keep a slip of the keyboard from filling the memory.
Result<Study> open_study(const StudyCall& call, const Experiment& experiment, Console& console,
                         const Progress& progress, std::vector<Finding>& told) {
    if (const Result<void> fine = check_resolution(call, experiment); !fine) return fine.error();
    Result<Study> study = prepare_study(experiment, study_settings(call.study, call.work), progress);
    if (!study) return study.error();
    if (const auto untested = untested_fit(*study); untested && call.fits) study->warnings.push_back(*untested);
    const bool choosable_steps = choosable(study->settings);
    if (call.step_choice == StepChoice::before && choosable_steps) {
        told = findings_on_units(*study);
        tell_findings(told, {}, console);
        choose_declared_steps(*study, told, progress);
    }
    if (const Result<void> few = check_steps(*study); !few) return few.error();
    if (call.step_choice != StepChoice::in_run || !choosable_steps) check_integration(*study);
    return study;
}

}  // namespace

void declare_study_call(CLI::App& app, StudyCall& call) {
    app.add_option("EXP", call.experiment, "experiment folder, or a .toml file of one")->type_name("");
    if (call.writes_folder) app.add_option("--out", call.out, "folder for the results, made when missing")->type_name("DIR");
    add_study_options(app, call.study);
    add_work_options(app, call.work);
}

std::vector<std::filesystem::path> trace_files_and(const StudyCall& call, const Experiment& experiment,
                                                   const std::vector<std::string>& names) {
    std::vector<std::filesystem::path> files = trace_files(call.out, experiment);
    for (const std::string& name : names) files.push_back(call.out / name);
    return files;
}

StudyOpening open_command(const StudyCall& call, TrialChoice choice, const std::string& first_result, Console& console, const Progress& progress) {
    StudyOpening opening;
    Result<Experiment> experiment = open_experiment(call, opening.lock);
    const Result<std::size_t> trial = experiment ? find_trial(*experiment, call.trial) : Result<std::size_t>(experiment.error());
    if (!trial) {
        opening.status = console.refuse(trial.error());
        return opening;
    }
    // Commands on one trial work on its model alone.
    if (choice == TrialChoice::one && !experiment->effects.empty()) {
        opening.status = console.refuse(declaration_error(*experiment, "effect[0].id", "simulate, calibrate and diagnose know declared effects; this command does not"));
        return opening;
    }
    Result<Study> study = open_study(call, *experiment, console, progress, opening.told);
    opening.experiment = std::move(*experiment);
    if (progress.cancelled()) opening.status = stopped_before(first_result, console);
    else if (!study) opening.status = console.refuse(study.error());
    else opening.study = choice == TrialChoice::one ? with_one_trial(std::move(*study), *trial) : std::move(*study);
    return opening;
}

int stopped_before(const std::string& first_result, Console& console) {
    console.complain("stopped before " + first_result + "; nothing was written");
    return status_stopped;
}

void tell_findings(const std::vector<Finding>& findings, const std::vector<Finding>& before, Console& console) {
    const std::vector<std::string> said = untold(before);
    for (const std::string& sentence : untold(findings))
        if (std::find(said.begin(), said.end(), sentence) == said.end()) console.warn(sentence);
}

RunFacts run_facts(const StudyCall& call, double setup_s) {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return {MYOLOOP_VERSION, command_line(), setup_s, static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u, call.work.seed};
}

std::string assumed_damping(const Study& study) {
    if (study.experiment.material.damping_s) return {};
    return "material.damping_s is not declared; " + format_number(1e3 * study.trials.front().model.damping_s, 4) + " ms is assumed";
}

std::string size_line(const Study& study) {
    return mesh_words(study) + ", " + to_string(study.settings.integrator) + ", " +
           std::to_string(study.settings.threads) + (study.settings.threads == 1 ? " thread" : " threads");
}

std::string with_options(const std::string& failure) {
    return failure.ends_with(smaller_step_advice)
               ? failure + " (--dt), another mesh (--element, --resolution) or another --integrator"
               : failure;
}

std::string in_millimetres(double metres) {
    char text[32];
    if (std::isfinite(metres)) std::snprintf(text, sizeof text, "%9.3f", 1e3 * metres);
    else std::snprintf(text, sizeof text, "%9s", "-");
    return text;
}

}  // namespace myo
