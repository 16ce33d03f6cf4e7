#include "experiment_command.hpp"

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
#include "effect/catalogue.hpp"
#include "exit_status.hpp"
#include "experiment/check_body.hpp"
#include "experiment/leave_out.hpp"
#include "experiment/read_experiment.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/quality.hpp"
#include "prediction/time_step.hpp"
#include "prediction/trial_target.hpp"
#include "prediction/untested_fit.hpp"
#include "results/finding_output.hpp"
#include "results/output_files.hpp"
#include "setup/mesh_words.hpp"

namespace myo::app {
namespace {

/// Total memory of the machine [bytes], not what is free now.
double physical_memory_bytes() {
    return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGE_SIZE));
}

/// Rejects an edge length that would make more elements than the limit, before meshing.
Result<void> check_resolution(const ExperimentCall& call, const experiment::Experiment& experiment) {
    if (!call.setup.settings.mesh.resolution_m) return {};
    const Result<mesh::SurfaceMesh> surface = experiment::read_body_surface(experiment);
    if (!surface) return {};  // prepare_setup() reports the error
    const fem::ElementKind element = call.setup.settings.mesh.element.value_or(setup::automatic_element(*surface));
    const double edge = *call.setup.settings.mesh.resolution_m;
    const mesh::CountEstimate estimate = mesh::estimate_counts(*surface, fem::cell_type(element), edge);
    if (!(estimate.cells > mesh::box_mesh_policy.max_grid_cells)) return {};
    return Error{"an edge length of " + format_number(edge) + " m would make about " +
                     format_number(estimate.cells, 2) + " elements; the limit is 2 million",
                 "--resolution"};
}

/// Rejects steps whose stored states would exceed 70 % of the memory: position and velocity, 6 doubles per node and
/// step.
Result<void> check_steps(const setup::Setup& setup) {
    double bytes = 0.0, steps = 0.0;
    for (const setup::PreparedTrial& trial : setup.trials) {
        const double own = trial.options.end_s / trial.options.h_s;
        steps += own;
        bytes += own * static_cast<double>(setup.mesh.mesh.node_count()) * 6.0 * sizeof(double);
    }
    if (bytes < 0.7 * physical_memory_bytes()) return {};
    return Error{"the trials would take " + format_number(steps, 2) + " steps, whose states need " +
                     format_number(1e-9 * bytes, 2) + " GB of memory; choose a larger step or a coarser mesh",
                 "--dt"};
}

/// Reads the experiment and reserves the output folder for this run; fast checks only.
Result<experiment::Experiment> open_experiment(const ExperimentCall& call, std::optional<FolderLock>& lock) {
    if (call.experiment.empty()) return Error{"name an experiment folder", ""};
    if (call.writes_folder && call.out.empty()) return Error{"name a folder for the results", "--out"};
    // Options that would be ignored silently are errors.
    if (call.setup.spectral_radius && call.setup.settings.integrator != dynamics::Integrator::generalized_alpha)
        return Error{"only --integrator " + to_string(dynamics::Integrator::generalized_alpha) + " has one to choose",
                     "--spectral-radius"};
    Result<experiment::Experiment> experiment = experiment::read_experiment(call.experiment, call.setup.overrides);
    if (!experiment) return experiment;
    // Names of effects may be laws of the experiment, so they are checked once it is read.
    for (const auto& [option, ids] : call.named_effects)
        for (const std::string& id : *ids)
            if (effect::find_effect(id, experiment->laws) == nullptr)
                return Error{unknown_word(id, effect::effect_ids(experiment->laws)), option};
    if (call.leave_out > 0) {
        const Result<std::vector<std::string>> left = experiment::leave_out(*experiment, call.leave_out,
                                                                            call.work.seed.value_or(1));
        if (!left) return left.error();
        experiment->warnings.push_back("left out of the fit, and predicted: " + join(*left));
    }
    // Nothing is created on disk before all files of the call are known to be harmless.
    const Result<void> kept = check_overwrites(call.writes_folder ? "--out" : "--json", call.outputs(*experiment),
                                               results::files_read(call.experiment, *experiment));
    if (!kept) return kept.error();
    if (!call.writes_folder) return experiment;
    if (const Result<void> folder = results::prepare_output_folder(call.out); !folder)
        return Error{folder.error().text(), "--out"};
    Result<FolderLock> taken = FolderLock::take(call.out);
    if (!taken) return Error{taken.error().text(), "--out"};
    lock = std::move(*taken);
    return experiment;
}

/// prepare_setup() with limits, so that a typing error does not fill the memory.
Result<setup::Setup> open_setup(const ExperimentCall& call, const experiment::Experiment& experiment, Console& console,
                                const Progress& progress, std::vector<check::Finding>& told) {
    if (const Result<void> fine = check_resolution(call, experiment); !fine) return fine.error();
    Result<setup::Setup> setup = setup::prepare_setup(experiment, setup_settings(call.setup, call.work), progress);
    if (!setup) return setup.error();
    // Only commands that fit need recorded trials, and some for testing.
    if (call.fits)
        if (const Result<void> fit = prediction::require_fit_trial(*setup); !fit) return fit.error();
    if (const auto untested = prediction::untested_fit(*setup); untested && call.fits)
        setup->warnings.push_back(*untested);
    const bool choosable_steps = prediction::choosable(setup->settings);
    // A trial in milliseconds read as seconds is refused; a doubtful unit is only reported.
    const std::vector<check::Finding> on_units = check::findings_on_units(*setup);
    if (const Result<void> in_seconds = check::require_time_unit(*setup, on_units); !in_seconds)
        return in_seconds.error();
    if (call.step_choice == StepChoice::before && choosable_steps) {
        told = on_units;
        // A wrong unit is reported first, since the choice of steps may then take long.
        tell_findings(told, {}, console);
        check::choose_declared_steps(*setup, told, progress);
    }
    // After the choice of steps, which decides how many states are stored.
    if (const Result<void> few = check_steps(*setup); !few) return few.error();
    // Steps that the run chooses itself are checked after it.
    if (call.step_choice != StepChoice::in_run || !choosable_steps) setup::check_integration(*setup);
    return setup;
}

}  // namespace

void add_named_effects(CLI::App& app, const std::string& name, std::vector<std::string>& target,
                       const std::string& help, ExperimentCall& call) {
    call.named_effects.emplace_back(name, &target);
    app.add_option_function<std::string>(
           name, [&target](const std::string& text) { target = split_words(text); }, help)
        ->type_name("A,B");
}

void declare_leave_out(CLI::App& app, ExperimentCall& call) {
    add_count(app, "--leave-out", call.leave_out,
              "fit trials to leave out of the fit and to predict, drawn by --seed (default 1)")
        ->default_str("");
}

std::string distance_line(const prediction::SetupRun& before, const prediction::SetupRun& after) {
    std::string text;
    for (const experiment::TrialRole role : {experiment::TrialRole::fit, experiment::TrialRole::validate}) {
        const auto mean = [&](const prediction::SetupRun& run) {
            double sum = 0.0, count = 0.0;
            for (const prediction::TrialScore& score : run.scores)
                if (score.role == role) sum += score.distance_m, ++count;
            return sum / count;
        };
        // 0 / 0: no trial of this role was run.
        if (std::isnan(mean(before)) && std::isnan(mean(after))) continue;
        text += (text.empty() ? "" : "\n") + std::string("mean distance of the markers in the ") +
                (role == experiment::TrialRole::fit ? "fitted" : "predicted") + " trials [mm] " +
                in_millimetres(mean(before)) + "  " + in_millimetres(mean(after));
    }
    return text;
}

void declare_experiment_call(CLI::App& app, ExperimentCall& call) {
    app.add_option("EXP", call.experiment, "experiment folder, or a .toml file of one")->type_name("");
    if (call.writes_folder)
        app.add_option("--out", call.out, "folder for the results, made when missing")->type_name("DIR");
    add_setup_options(app, call.setup);
    add_work_options(app, call.work);
}

std::vector<std::filesystem::path> trace_files_and(const ExperimentCall& call, const experiment::Experiment& experiment,
                                                   const std::vector<std::string>& names) {
    std::vector<std::filesystem::path> files = results::trace_files(call.out, experiment);
    for (const std::string& name : names) files.push_back(call.out / name);
    return files;
}

std::filesystem::path declaration_of(const ExperimentCall& call) {
    std::error_code code;
    return std::filesystem::is_directory(call.experiment, code) ? call.experiment / "experiment.toml" : call.experiment;
}

OpenedExperiment open_command(const ExperimentCall& call, TrialChoice choice, const std::string& first_result,
                              Console& console, const Progress& progress) {
    OpenedExperiment opening;
    Result<experiment::Experiment> experiment = open_experiment(call, opening.lock);
    // The trial name is checked before the mesh is made.
    const Result<std::size_t> trial = experiment ? prediction::find_trial(*experiment, call.trial)
                                                 : Result<std::size_t>(experiment.error());
    if (!trial) {
        opening.status = console.refuse(trial.error());
        return opening;
    }
    Result<setup::Setup> setup = open_setup(call, *experiment, console, progress, opening.told);
    opening.experiment = std::move(*experiment);
    // A cancelled preparation returns an error as well, which would read like wrong input.
    if (progress.cancelled())
        opening.status = stopped_before(first_result, console);
    else if (!setup)
        opening.status = console.refuse(setup.error());
    else
        opening.setup = choice == TrialChoice::one ? prediction::with_one_trial(std::move(*setup), *trial)
                                                   : std::move(*setup);
    return opening;
}

int stopped_before(const std::string& first_result, Console& console) {
    console.complain("stopped before " + first_result + "; nothing was written");
    return status_stopped;
}

void tell_findings(const std::vector<check::Finding>& findings, const std::vector<check::Finding>& before,
                   Console& console) {
    const std::vector<std::string> said = results::sentences_to_report(before);
    for (const std::string& sentence : results::sentences_to_report(findings))
        if (std::find(said.begin(), said.end(), sentence) == said.end()) console.warn(sentence);
}

results::RunFacts run_facts(const ExperimentCall& call, double setup_s) {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    // Linux gives ru_maxrss in KiB.
    return {MYOLOOP_VERSION, command_line(), setup_s, static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u,
            call.work.seed};
}

std::string assumed_damping(const setup::Setup& setup) {
    if (setup.experiment.material.damping_s) return {};
    return "material.damping_s is not declared; " + format_number(1e3 * setup.trials.front().model.damping_s, 4) +
           " ms is assumed";
}

std::string size_line(const setup::Setup& setup) {
    return setup::mesh_words(setup) + ", " + to_string(setup.settings.integrator) + ", " +
           std::to_string(setup.settings.threads) + (setup.settings.threads == 1 ? " thread" : " threads");
}

std::string with_options(const std::string& failure) {
    return failure.ends_with(dynamics::smaller_step_advice)
               ? failure + " (--dt), another mesh (--element, --resolution) or another --integrator"
               : failure;
}

std::string in_millimetres(double metres) {
    char text[32];
    if (std::isfinite(metres))
        std::snprintf(text, sizeof text, "%9.3f", 1e3 * metres);
    else
        std::snprintf(text, sizeof text, "%9s", "-");
    return text;
}

}  // namespace myo::app
