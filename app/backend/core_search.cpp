#include "backend/core_search.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "backend/check_rows.hpp"
#include "backend/core_scene.hpp"
#include "backend/law_settings.hpp"
#include "backend/search_pace.hpp"
#include "backend/shown_run.hpp"
#include "base/stopwatch.hpp"
#include "calibration/calibrate.hpp"
#include "check/catalogue.hpp"
#include "check/declared_steps.hpp"
#include "prediction/time_step.hpp"
#include "prediction/untested_fit.hpp"
#include "results/calibration_report.hpp"
#include "results/readable_parameter.hpp"

namespace myo::backend {
namespace {

constexpr double nothing_known = std::numeric_limits<double>::quiet_NaN();

/// Row of a parameter in displayed units.
///
/// @param start, value, deviation  SI; the deviation is one standard deviation, NaN: unknown
ui::commands::ParameterRow parameter_row(const prediction::ModelParameter& parameter, const setup::Setup& setup,
                                         double start, double value, double deviation) {
    const results::ReadableParameter shown = results::readable_parameter(parameter, setup);
    return {shown.name, shown.unit, shown.factor * start, shown.factor * value, shown.factor * deviation};
}

/// Displayable run from existing predictions of some trials; the others stay "not run".
///
/// @param predictions  one per entry of `trials`, in that order
std::shared_ptr<const ui::commands::RunResult> run_of(const setup::Setup& setup,
                                                      const prediction::ParameterValues& values,
                                                      const std::vector<std::size_t>& trials,
                                                      const std::vector<prediction::TrialPrediction>& predictions) {
    std::vector<prediction::TrialPrediction> all(setup.trials.size());
    for (std::size_t i = 0; i < trials.size(); ++i) all[trials[i]] = predictions[i];
    return std::make_shared<const ui::commands::RunResult>(
        shown_run(setup, prediction::scored_run(setup, values, std::move(all), trials)));
}

/// Indices of the trials that enter the fit.
std::vector<std::size_t> fit_trials(const setup::Setup& setup) {
    std::vector<std::size_t> trials;
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        if (setup.trials[t].role == experiment::TrialRole::fit) trials.push_back(t);
    return trials;
}

/// The best values so far, as rows and as settings. A standard deviation exists at the end of a fit only.
///
/// @param declared  values at which the fit started, for the column of start values
void show_values(ui::commands::SearchView& view, const setup::Setup& setup,
                 const std::vector<prediction::ModelParameter>& parameters, const prediction::ParameterValues& declared,
                 const prediction::ParameterValues& values, const ui::commands::Settings& settings) {
    view.parameters.clear();
    for (const prediction::ModelParameter& p : parameters)
        view.parameters.push_back(
            parameter_row(p, setup, prediction::value_of(p, declared), prediction::value_of(p, values), nothing_known));
    // The fields of the window show material values only; fitted effects and levels appear in the rows.
    view.settings = settings;
    view.settings.youngs_modulus_Pa = values.youngs_modulus_Pa;
    view.settings.damping_s = values.damping_s;
    set_law_values(values.law, view.settings);
}

/// Setup of a calibration, its steps chosen where the user did not set one.
Result<setup::Setup> setup_to_fit(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                                  const ui::commands::Settings& settings, const Progress& progress) {
    setup::SetupSettings chosen = setup_settings(settings);
    // A step that the user did not set may be replaced by one that suits the fit.
    if (!settings.own_step) chosen.h_s.reset();
    Result<setup::Setup> setup = scene_setup(scene, body, settings, chosen, progress);
    if (!setup) return setup;
    if (const std::optional<std::string> untested = prediction::untested_fit(*setup))
        setup->warnings.push_back(*untested);
    const std::vector<check::Finding> on_units = check::findings_on_units(*setup);
    // Before any run: steps for times in milliseconds read as seconds would take hours.
    if (const Result<void> in_seconds = check::require_time_unit(*setup, on_units); !in_seconds)
        return in_seconds.error();
    if (!chosen.h_s) check::choose_declared_steps(*setup, on_units, progress);
    setup::check_integration(*setup);
    return setup;
}

/// Rows of the fitted values, with standard deviations; the live rows have none. They start from the declared values,
/// although a fit that was repeated with shorter steps went on from those of the first.
std::vector<ui::commands::ParameterRow> fitted_rows(const setup::Setup& setup,
                                                    const calibration::Calibration& calibration) {
    const prediction::ParameterValues declared = prediction::declared_values(setup);
    std::vector<ui::commands::ParameterRow> rows;
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i)
        rows.push_back(parameter_row(calibration.parameters[i], setup,
                                     prediction::value_of(calibration.parameters[i], declared),
                                     calibration.fit.values(static_cast<Eigen::Index>(i)), calibration.deviation(i)));
    return rows;
}

/// The fitted material values as settings, and the step of the fit unless the user set one.
ui::commands::Settings fitted_settings(const setup::Setup& setup, const calibration::Calibration& calibration,
                                       ui::commands::Settings settings) {
    settings.youngs_modulus_Pa = calibration.after.values.youngs_modulus_Pa;
    settings.damping_s = calibration.after.values.damping_s;
    set_law_values(calibration.after.values.law, settings);
    if (!settings.own_step) settings.time_step_s = prediction::shortest_step_s(setup);
    return settings;
}

/// Run, checks and report page of a calibration.
void show_calibrated(ui::commands::SearchResult& result, const setup::Setup& setup,
                     const calibration::Calibration& calibration) {
    results::RunFacts facts{MYOLOOP_VERSION, {"workbench"}};
    const std::vector<setup::TrialStep> seen = prediction::steps_seen_in(setup, calibration.after);
    facts.findings = check::check_after(
        {.setup = setup, .run = &calibration.after, .calibration = &calibration, .seen = &seen});
    result.run = shown_run(setup, calibration.after);
    add_vibrations(seen, result.run);
    result.run.checks = check_rows(facts.findings);
    result.run.seconds = calibration.seconds;
    result.page = std::make_shared<const report::HtmlReport>(results::calibration_report(setup, calibration, facts));
}

/// The result of a calibration for the window.
ui::commands::SearchResult calibrated(const setup::Setup& setup, const calibration::Calibration& calibration,
                                      const ui::commands::Settings& settings) {
    ui::commands::SearchResult result;
    result.title = "Calibrated";
    result.evaluations = calibration.evaluations() + calibration.earlier_evaluations;
    result.stopped = calibration.stopped;
    result.warnings = calibration.warnings;
    if (const std::optional<std::string> untested = prediction::untested_fit(setup))
        result.warnings.push_back(*untested);
    if (!calibration.fit.converged() && !calibration.stopped)
        result.problem = "The fit did not converge: " + calibration.fit.message;
    result.parameters = fitted_rows(setup, calibration);
    result.rms_before_m = calibration.before.fit_rms_m;
    result.rms_after_m = calibration.after.fit_rms_m;
    result.settings = fitted_settings(setup, calibration, settings);
    show_calibrated(result, setup, calibration);
    return result;
}

}  // namespace

Result<ui::commands::SearchResult> calibrate_scene(const ui::commands::Scene& scene,
                                                   const ui::commands::MeshedBody& body,
                                                   const ui::commands::Settings& settings, const Progress& progress,
                                                   const ui::commands::Backend::LiveSearch& live) {
    Result<setup::Setup> setup = setup_to_fit(scene, body, settings, progress);
    if (!setup) return setup.error();
    if (const Result<void> fit = prediction::require_fit_trial(*setup); !fit) return fit.error();
    const std::vector<prediction::ModelParameter> parameters = prediction::free_parameters(*setup);
    const prediction::ParameterValues declared = prediction::declared_values(*setup);
    ui::commands::SearchView view;
    Pace pace;
    // Every evaluation extends the log; parameters and picture change only with a better one.
    calibration::CalibrationSettings how;
    // A failed evaluation has an infinite or undefined cost; its empty point keeps the count of evaluations right.
    how.evaluated = [&](const calibration::CalibrationStep& step) {
        view.log.push_back(std::isfinite(step.cost)
                               ? ui::commands::SearchPoint{step.cost, step.rms_m, step.gradient_norm}
                               : ui::commands::SearchPoint{});
        if (step.best) {
            show_values(view, *setup, parameters, declared, step.values, settings);
            // The run exists already (`step.best`), but its conversion for display costs time.
            if (pace.due()) {
                const Stopwatch watch;
                view.best = run_of(*setup, step.values, fit_trials(*setup), *step.best);
                pace.took(watch.seconds());
            }
        }
        if (live) live(std::make_shared<const ui::commands::SearchView>(view));
    };
    const calibration::Calibration calibration = calibration::calibrate_with_chosen_steps(*setup, how, progress);
    if (!calibration.usable()) return Error{calibration.fit.message, ""};
    return calibrated(*setup, calibration, settings);
}

}  // namespace myo::backend
