#include "commands/workflow.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/letter_case.hpp"
#include "commands/search_target.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::commands {
namespace {

/// Whether any trial has measured markers.
bool is_measured(const Scene& scene) {
    for (const SceneTrial& trial : scene.trials)
        if (trial.role != "simulate" && !trial.measured.empty()) return true;
    return false;
}

// The status of each task. All but that of the body require an open scene.
TaskStatus body_status(const WorkbenchState& state) {
    if (!state.scene) return {TaskState::missing, "Open an experiment folder, a mesh, or one of the examples."};
    return {TaskState::done, state.scene->name + " is open."};
}

TaskStatus mesh_status(const WorkbenchState& state) {
    if (!state.body) return {TaskState::ready, "Choose elements and an edge length, then build the mesh."};
    if (!state.mesh_is_current()) {
        // The sentence names what has changed: the declaration of the body, or the settings of the mesh.
        const bool declared = state.settings.declaration.mesh_words != state.body_settings.declaration.mesh_words;
        return {TaskState::stale, declared ? "The held part, the parts or the body changed: build the mesh again."
                                           : "Element or edge length changed: build the mesh again."};
    }
    return {TaskState::done, plot::plain_label(static_cast<double>(state.body->mesh.cell_count()), 7) +
                                 " elements of " + to_string(state.body->mesh.type) + "."};
}

/// Whether two settings have the same law with equal numbers.
bool same_material(const Settings& a, const Settings& b) {
    return a.material == b.material && a.law == b.law && a.youngs_modulus_Pa == b.youngs_modulus_Pa &&
           a.poissons_ratio == b.poissons_ratio && a.density_kg_m3 == b.density_kg_m3 && a.damping_s == b.damping_s;
}

TaskStatus material_status(const WorkbenchState& state) {
    const std::string values = "Young's modulus E = " + plot::plain_label(1e-3 * state.settings.youngs_modulus_Pa, 4) +
                               " kPa, Poisson's ratio \xce\xbd = " +
                               plot::plain_label(state.settings.poissons_ratio, 4) + ".";
    // Default values of a plain mesh have not been checked by anyone, so the task is not done yet.
    if (!is_measured(*state.scene) && same_material(state.settings, state.scene->settings))
        return {TaskState::ready, "A silicone is assumed; set the values of your material. " + values};
    return {TaskState::done, values};
}

TaskStatus fibres_status(const WorkbenchState& state) {
    if (state.settings.muscles.empty() && state.body && !state.actuators.empty())
        return {TaskState::done, std::string(state.actuators.tendons.empty()    ? "Chambers drive the body."
                                             : state.actuators.chambers.empty() ? "Tendons drive the body."
                                                                                : "Chambers and tendons drive "
                                                                                  "the body.")};
    if (state.settings.muscles.empty())
        return {TaskState::ready, "No muscles: add one and paint it on the body, or leave it passive."};
    // The first muscle without paint is what is missing.
    for (std::size_t m = 0; m < state.settings.muscles.size() && m < state.paint.size(); ++m)
        if (state.paint[m] && !(state.paint[m]->weights.maxCoeff() > 0.0))
            return {TaskState::ready, "Paint " + state.settings.muscles[m].name + " on the body."};
    const std::size_t count = state.settings.muscles.size();
    return {TaskState::done, std::to_string(count) + (count == 1 ? " muscle is painted." : " muscles are painted.")};
}

TaskStatus run_status(const WorkbenchState& state) {
    if (!state.run) return {TaskState::ready, "Choose the time step, then run."};
    if (!state.run_is_current())
        return {TaskState::stale, state.previewing()
                                      ? "The settings changed since the last run; the view shows their preview."
                                      : "The settings changed since the last run: run again."};
    return {TaskState::done, "Run in " + plot::value_label(state.run->seconds, 2) + " s."};
}

TaskStatus measure_status(const WorkbenchState& state) {
    if (!is_measured(*state.scene)) return {TaskState::missing, "No measured markers to compare with."};
    if (!state.run) return {TaskState::ready, "Run to see the error against the markers."};
    if (!state.run_is_current()) return {TaskState::stale, "The errors are of earlier settings: run again."};
    return {TaskState::done, "Error against the markers " + plot::millimetres(state.run->rms_m) + " rms."};
}

TaskStatus fit_status(const WorkbenchState& state) {
    if (!is_measured(*state.scene) && !any_goals(*state.scene))
        return {TaskState::missing, "A fit needs measured markers or goals."};
    // Something to follow, and something to change: unknown values, or actuators with signals.
    if (state.scene->calibrated.empty() && !has_actuators(*state.scene, state.settings))
        return {TaskState::missing, "Unknown parameters: none. Tick one, or add a muscle, chamber or tendon."};
    if (!state.found)
        return {TaskState::ready, state.scene->calibrated.empty()
                                      ? "Optimise signals and design."
                                      : "Calibrate the values that are unknown, or optimise signals and design."};
    if (!(state.settings == state.found->settings)) return {TaskState::stale, "The settings changed since the fit."};
    return {TaskState::done, state.found->title + ": " + plot::millimetres(state.found->rms_before_m) +
                                 " \xe2\x86\x92 " + plot::millimetres(state.found->rms_after_m) + "."};
}

TaskStatus diagnose_status(const WorkbenchState& state) {
    if (!can_be_diagnosed(*state.scene))
        return {TaskState::missing, "A diagnosis needs a trial of role fit with measured markers."};
    if (!state.diagnosis || !state.diagnosis->complete) return {TaskState::ready, "Find missing effects."};
    // Adding an effect follows the diagnosis' own recommendation, so it does not make the diagnosis outdated.
    Settings bare = state.settings, then = state.diagnosis_settings;
    bare.effects.clear(), then.effects.clear();
    bare.youngs_modulus_Pa = then.youngs_modulus_Pa, bare.damping_s = then.damping_s;
    if (!(bare == then)) return {TaskState::stale, "The settings changed since the diagnosis."};
    const DiagnosisRow* const verdict = state.diagnosis->chosen_row();
    if (verdict && is_in_model(state, *verdict))
        return {TaskState::done, verdict->name + " was missing and is in the model now."};
    return {TaskState::done, state.diagnosis->headline + "."};
}

TaskStatus report_status(const WorkbenchState& state) {
    if (!state.run) return {TaskState::missing, "A report needs a run."};
    if (!state.run_is_current()) return {TaskState::stale, "The run is of earlier settings: run again."};
    return {TaskState::ready, "Write the report, pictures and tables."};
}

/// State of a task without regard to its checks.
TaskStatus bare_status(const WorkbenchState& state, Task task) {
    switch (task) {
        case Task::body: return body_status(state);
        case Task::mesh: return mesh_status(state);
        case Task::material: return material_status(state);
        case Task::fibres: return fibres_status(state);
        case Task::run: return run_status(state);
        case Task::measure: return measure_status(state);
        case Task::fit: return fit_status(state);
        case Task::diagnose: return diagnose_status(state);
        case Task::report: return report_status(state);
    }
    return {};
}

/// Checks of a run without those that a calibration would resolve: a run is sound even if its parameters do not fit
/// yet. Its comparison with the recording is not: there the residual counts.
CheckRows checks_of_run(CheckRows rows, bool compared) {
    std::erase_if(rows, [&](const CheckRow& row) {
        return row.task == task_id(Task::fit) && !(compared && row.id == "residual");
    });
    return rows;
}

/// Why the result of a search has no tick, whatever its checks say. Empty: nothing is wrong.
std::string doubt_about(const SearchResult& found) {
    if (found.stopped) return "Cancelled before its end: these are the best values up to then.";
    if (!found.problem.empty()) return found.problem;
    if (!(found.rms_after_m <= found.rms_before_m)) return "The error is not less than before.";
    return {};
}

/// The worst finding in words, with what the user can do.
std::string reason_of(const CheckRows& rows) {
    const auto worst = std::max_element(rows.begin(), rows.end(),
                                        [](const CheckRow& a, const CheckRow& b) { return a.state < b.state; });
    if (worst == rows.end() || worst->state == CheckState::green) return {};
    const std::string told = " " + upper_first(worst->sentence) + ".";
    return worst->way_out.empty() ? told : told + " " + upper_first(worst->way_out) + ".";
}

/// Checks of the job that completes a task. For the other tasks, the newest checks that concern them.
CheckRows checks_of(const WorkbenchState& state, Task task) {
    if (task == Task::run || task == Task::measure) return checks_of_run(state.run->checks, task == Task::measure);
    if (task == Task::fit) return state.found->run.checks;
    if (task == Task::diagnose) return state.diagnosis->checks;
    CheckRows rows;
    if (state.checks)
        std::copy_if(state.checks->rows.begin(), state.checks->rows.end(), std::back_inserter(rows),
                     [&](const CheckRow& row) { return row.task == task_id(task); });
    return rows;
}

}  // namespace

const char* task_id(Task task) {
    static constexpr std::array<const char*, 9> ids{"body",    "mesh", "material", "fibres", "run",
                                                    "measure", "fit",  "diagnose", "report"};
    return ids[static_cast<std::size_t>(task)];
}

const char* task_title(Task task) {
    static constexpr std::array<const char*, 9> titles{"Body",    "Mesh", "Material", "Fibres", "Run",
                                                       "Measure", "Fit",  "Diagnose", "Report"};
    return titles[static_cast<std::size_t>(task)];
}

TaskStatus task_status(const WorkbenchState& state, Task task) {
    if (!state.scene && task != Task::body) return {TaskState::missing, "Open a body first."};
    TaskStatus status = bare_status(state, task);
    // Checks qualify only what has been done with the present settings.
    if (status.state != TaskState::done || !state.scene) return status;
    const CheckRows rows = checks_of(state, task);
    status.checks = worst_state(rows);
    if (status.checks != CheckState::green) status.next += " Checks: " + doubt_text(rows) + "." + reason_of(rows);
    const std::string doubt = task == Task::fit ? doubt_about(*state.found) : "";
    if (doubt.empty()) return status;
    status.checks = std::max(status.checks, CheckState::amber);
    status.next += " " + doubt;
    return status;
}

Task next_task(const WorkbenchState& state) {
    if (!state.scene) return Task::body;
    // What is outdated comes before what has not been done yet.
    for (const TaskState wanted : {TaskState::stale, TaskState::ready})
        for (const Task task : all_tasks)
            if (task_status(state, task).state == wanted) return task;
    return Task::report;
}

}  // namespace myo::ui::commands
