#include "commands/workflow.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "plot/ticks.hpp"

namespace myo::ui::commands {
namespace {

/// Whether any trial has measured markers.
bool is_measured(const Scene& scene) {
    for (const SceneTrial& trial : scene.trials)
        if (!trial.measured.empty()) return true;
    return false;
}

StepStatus body_status(const WorkbenchState& state) {
    if (!state.scene) return {StepState::missing, "Open an experiment folder, a mesh, or one of the examples."};
    return {StepState::done, state.scene->name + " is open."};
}

StepStatus mesh_status(const WorkbenchState& state) {
    if (!state.body) return {StepState::ready, "Choose elements and an edge length, then build the mesh."};
    if (!state.mesh_is_current()) return {StepState::stale, "Element or edge length changed: build the mesh again."};
    return {StepState::done, plot::plain_label(static_cast<double>(state.body->mesh.cell_count()), 7) +
                                 " elements of " + to_string(state.body->mesh.type) + "."};
}

StepStatus material_status(const WorkbenchState& state) {
    const std::string values = "E = " + plot::plain_label(1e-3 * state.settings.youngs_modulus_Pa, 4) +
                               " kPa, \xce\xbd = " + plot::plain_label(state.settings.poissons_ratio, 4) + ".";
    // Default values of a plain mesh have not been checked by anyone, so the task is not done yet.
    if (!is_measured(*state.scene) && state.settings == state.scene->settings)
        return {StepState::ready, "A silicone is assumed; set the values of your material. " + values};
    return {StepState::done, values};
}

StepStatus fibres_status(const WorkbenchState& state) {
    if (state.settings.muscles.empty())
        return {StepState::ready, "No muscles: add one and paint it on the body, or leave it passive."};
    // The first muscle without paint is what is missing.
    for (std::size_t m = 0; m < state.settings.muscles.size() && m < state.paint.size(); ++m)
        if (state.paint[m] && !(state.paint[m]->weights.maxCoeff() > 0.0))
            return {StepState::ready, "Paint " + state.settings.muscles[m].name + " on the body."};
    const std::size_t count = state.settings.muscles.size();
    return {StepState::done, std::to_string(count) + (count == 1 ? " muscle is painted." : " muscles are painted.")};
}

StepStatus run_status(const WorkbenchState& state) {
    if (!state.run) return {StepState::ready, "Choose the time step, then run."};
    if (!state.run_is_current()) return {StepState::stale, "The settings changed since the last run: run again."};
    return {StepState::done, "Run in " + plot::value_label(state.run->seconds, 2) + " s."};
}

StepStatus measure_status(const WorkbenchState& state) {
    if (!is_measured(*state.scene)) return {StepState::missing, "No measured markers to compare with."};
    if (!state.run) return {StepState::ready, "Run to see the error against the markers."};
    if (!state.run_is_current()) return {StepState::stale, "The errors are of earlier settings: run again."};
    return {StepState::done, "Error against the markers " + plot::millimetres(state.run->rms_m) + " rms."};
}

StepStatus fit_status(const WorkbenchState& state) {
    if (!is_measured(*state.scene)) return {StepState::missing, "A fit needs measured markers."};
    if (state.scene->calibrated.empty() && state.settings.muscles.empty())
        return {StepState::missing, "Unknown parameters: none. No muscle to optimise."};
    if (!state.found)
        return {StepState::ready, state.scene->calibrated.empty()
                                      ? "Optimise the muscles' signals."
                                      : "Calibrate the values that are unknown, or optimise the muscles' signals."};
    if (!(state.settings == state.found->settings)) return {StepState::stale, "The settings changed since the fit."};
    return {StepState::done, state.found->title + ": " + plot::millimetres(state.found->rms_before_m) +
                                 " \xe2\x86\x92 " + plot::millimetres(state.found->rms_after_m) + "."};
}

StepStatus diagnose_status(const WorkbenchState& state) {
    if (!can_be_diagnosed(*state.scene))
        return {StepState::missing, "A diagnosis needs a trial of role fit with measured markers."};
    if (!state.diagnosis || !state.diagnosis->complete) return {StepState::ready, "Find missing effects."};
    // Adding an effect follows the diagnosis' own recommendation, so it does not make the diagnosis outdated.
    Settings bare = state.settings, then = state.diagnosis_settings;
    bare.effects.clear(), then.effects.clear();
    bare.youngs_modulus_Pa = then.youngs_modulus_Pa, bare.damping_s = then.damping_s;
    if (!(bare == then)) return {StepState::stale, "The settings changed since the diagnosis."};
    return {StepState::done, state.diagnosis->headline + "."};
}

StepStatus report_status(const WorkbenchState& state) {
    if (!state.run) return {StepState::missing, "A report needs a run."};
    if (!state.run_is_current()) return {StepState::stale, "The run is of earlier settings: run again."};
    return {StepState::ready, "Write the report, pictures and tables."};
}

/// State of a task without regard to its checks.
StepStatus bare_status(const WorkbenchState& state, Step step) {
    switch (step) {
        case Step::body: return body_status(state);
        case Step::mesh: return mesh_status(state);
        case Step::material: return material_status(state);
        case Step::fibres: return fibres_status(state);
        case Step::run: return run_status(state);
        case Step::measure: return measure_status(state);
        case Step::fit: return fit_status(state);
        case Step::diagnose: return diagnose_status(state);
        case Step::report: return report_status(state);
    }
    return {};
}

/// Checks of a run without those that a calibration would resolve: a run is sound even if its parameters do not fit
/// yet.
CheckRows checks_of_run(CheckRows rows) {
    std::erase_if(rows, [](const CheckRow& row) { return row.step == step_id(Step::fit); });
    return rows;
}

/// Checks of the job that completes a task. For the other tasks, the newest checks that concern them.
CheckRows checks_of(const WorkbenchState& state, Step step) {
    if (step == Step::run || step == Step::measure) return checks_of_run(state.run->checks);
    if (step == Step::fit) return state.found->run.checks;
    if (step == Step::diagnose) return state.diagnosis->checks;
    CheckRows rows;
    if (state.checks)
        std::copy_if(state.checks->rows.begin(), state.checks->rows.end(), std::back_inserter(rows),
                     [&](const CheckRow& row) { return row.step == step_id(step); });
    return rows;
}

}  // namespace

const char* step_id(Step step) {
    static constexpr std::array<const char*, 9> ids{"body",    "mesh", "material", "fibres", "run",
                                                    "measure", "fit",  "diagnose", "report"};
    return ids[static_cast<std::size_t>(step)];
}

const char* step_title(Step step) {
    static constexpr std::array<const char*, 9> titles{"Body",    "Mesh", "Material", "Fibres", "Run",
                                                       "Measure", "Fit",  "Diagnose", "Report"};
    return titles[static_cast<std::size_t>(step)];
}

StepStatus step_status(const WorkbenchState& state, Step step) {
    if (!state.scene && step != Step::body) return {StepState::missing, "Open a body first."};
    StepStatus status = bare_status(state, step);
    // Checks qualify only what has been done with the present settings.
    if (status.state != StepState::done || !state.scene) return status;
    const CheckRows rows = checks_of(state, step);
    status.checks = worst_state(rows);
    if (status.checks != CheckState::green) status.next += " Checks: " + doubt_words(rows) + ".";
    return status;
}

Step next_step(const WorkbenchState& state) {
    if (!state.scene) return Step::body;
    for (const StepState wanted : {StepState::stale, StepState::ready})
        for (const Step step : all_steps)
            if (step_status(state, step).state == wanted) return step;
    return Step::report;
}

}  // namespace myo::ui::commands
