#include "backend/core_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "backend/check_rows.hpp"
#include "backend/core_scene.hpp"
#include "backend/law_settings.hpp"
#include "backend/shown_run.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "calibration/calibrate.hpp"
#include "check/catalogue.hpp"
#include "check/declared_steps.hpp"
#include "experiment/actuators.hpp"
#include "prediction/time_step.hpp"
#include "prediction/trial_target.hpp"
#include "prediction/untested_fit.hpp"
#include "results/calibration_report.hpp"
#include "results/optimize_output.hpp"
#include "results/readable_parameter.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::backend {
namespace {

constexpr double nothing_known = std::numeric_limits<double>::quiet_NaN();

/// Row of a parameter in displayed units; start, value and deviation in SI.
ui::commands::ParameterRow parameter_row(const prediction::ModelParameter& parameter, const setup::Setup& setup,
                                         double start, double value, double deviation) {
    const results::ReadableParameter shown = results::readable_parameter(parameter, setup);
    return {shown.name, shown.unit, shown.factor * start, shown.factor * value, shown.factor * deviation};
}

/// Limits how often the best result is displayed: drawing may take a fifth of the time.
class Pace {
public:
    bool due() const { return first_ || since_.seconds() > std::max(0.5, 4.0 * cost_s_); }
    void took(double seconds) {
        cost_s_ = seconds;
        first_ = false;
        since_ = Stopwatch();
    }

private:
    bool first_ = true;
    double cost_s_ = 0.0;
    Stopwatch since_;
};

/// Displayable run from existing predictions of some trials.
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

/// Signals drawn by the user, sampled at the unknown knots and limited to their bounds.
Eigen::MatrixXd drawn_values(const setup::Setup& setup, const inverse::ActuationProblem& problem) {
    Eigen::MatrixXd values = inverse::unmoved_values(problem.sought);
    const std::vector<double> times = inverse::knot_times(problem.sought);
    for (Eigen::Index s = 0; s < values.rows(); ++s) {
        const inverse::SoughtSignal& signal = problem.sought.signals[static_cast<std::size_t>(s)];
        const std::size_t actuator = *experiment::find_actuator(setup.experiment, signal.name);
        const fibre::Signal& drawn = setup::actuator_signal(setup.experiment, setup.trials.front().model, actuator);
        for (Eigen::Index k = 0; k < values.cols(); ++k)
            values(s, k) = std::clamp(drawn.value(times[static_cast<std::size_t>(k)]), signal.lower, signal.upper);
    }
    return values;
}

/// The settings with these signals in place of the drawn ones.
ui::commands::Settings with_signals(ui::commands::Settings settings, const std::vector<fibre::Signal>& activation) {
    for (std::size_t m = 0; m < settings.muscles.size() && m < activation.size(); ++m)
        if (settings.muscles[m].follows.empty()) settings.muscles[m].signal = activation[m];
    return settings;
}

/// Smallest and largest value of each signal, at the start and now.
std::vector<ui::commands::ParameterRow> signal_rows(const setup::Setup& setup, const inverse::ActuationProblem& problem,
                                                    const Eigen::MatrixXd& start, const Eigen::MatrixXd& values) {
    std::vector<ui::commands::ParameterRow> rows;
    for (std::size_t s = 0; s < problem.sought.signals.size(); ++s) {
        const auto row = static_cast<Eigen::Index>(s);
        const std::string& name = problem.sought.signals[s].name;
        const experiment::Actuator actuator = experiment::actuators(
            setup.experiment)[*experiment::find_actuator(setup.experiment, name)];
        const bool muscle = actuator.kind == experiment::ActuatorKind::muscle;
        const std::string word = muscle ? "a" : experiment::quantity_word(actuator.kind);
        rows.push_back({name + ", minimum " + word, actuator.unit, start.row(row).minCoeff(),
                        values.row(row).minCoeff(), nothing_known});
        rows.push_back({name + ", maximum " + word, actuator.unit, start.row(row).maxCoeff(),
                        values.row(row).maxCoeff(), nothing_known});
    }
    return rows;
}

/// Displays a running search for signals.
class LiveOptimization {
public:
    LiveOptimization(const setup::Setup& setup, std::size_t trial, const inverse::ActuationProblem& problem,
                     Eigen::MatrixXd start, const ui::commands::Settings& settings, const Progress& progress,
                     const ui::commands::Backend::LiveSearch& live)
        : setup_(setup),
          trial_(trial),
          problem_(problem),
          start_(std::move(start)),
          settings_(settings),
          progress_(progress),
          live_(live) {
        view_.loss_unit = "mm\xc2\xb2";
    }

    void show(const inverse::ActuationFit& fit) {
        const inverse::ActuationIterate& line = fit.log.back();
        // A failed evaluation is an empty point, so that the count of evaluations stays right.
        view_.log.push_back(line.ok
                                ? ui::commands::SearchPoint{1e6 * line.loss_m2, line.rms_m, 1e6 * line.gradient_norm_m2}
                                : ui::commands::SearchPoint{});
        if (fit.usable()) {
            const std::vector<fibre::Signal> activation = inverse::commands_of(problem_.sought, fit.values);
            view_.parameters = signal_rows(setup_, problem_, start_, fit.values);
            view_.settings = with_signals(settings_, activation);
            // Only an evaluation that is the best so far changes the picture.
            if (line.ok && line.loss_m2 == fit.best.loss_m2 && pace_.due()) {
                const Stopwatch watch;
                if (auto run = run_with(fit.values, fit.best.placement))
                    view_.best = std::make_shared<const ui::commands::RunResult>(std::move(*run)), shown_ = fit.values;
                pace_.took(watch.seconds());
            }
        }
        if (live_) live_(std::make_shared<const ui::commands::SearchView>(view_));
    }

    /// The trial with the final signals. After a cancellation, only the part of the motion that is already known.
    ui::commands::RunResult found(const inverse::ActuationFit& fit) const {
        // The last displayed run is reused if it has the final signals.
        if (view_.best && shown_.size() > 0 && shown_ == fit.values) return *view_.best;
        if (auto run = run_with(fit.values, fit.best.placement)) return std::move(*run);
        return with_prediction(with_signals_of(fit.values),
                               prediction::prediction_of(setup_, trial_, fit.best.motion, fit.best.placement),
                               fit.best.placement);
    }

private:
    /// The setup with these signals in all trials.
    setup::Setup with_signals_of(const Eigen::MatrixXd& found) const {
        setup::Setup setup = setup_;
        for (setup::PreparedTrial& trial : setup.trials)
            trial.model = inverse::driven_model(std::move(trial.model), inverse::commands_of(problem_.sought, found));
        return setup;
    }

    /// Displayable run from the prediction of the one trial, with the found marker placement.
    ui::commands::RunResult with_prediction(const setup::Setup& setup, prediction::TrialPrediction prediction,
                                            const inverse::MarkerPlacement& placement) const {
        std::vector<prediction::TrialPrediction> predictions(setup.trials.size());
        predictions[trial_] = std::move(prediction);
        return shown_run(setup, prediction::scored_run(setup, prediction::placed_values(setup, placement),
                                                       std::move(predictions), {trial_}));
    }

    /// Simulates the trial with these signals; empty if cancelled.
    std::optional<ui::commands::RunResult> run_with(const Eigen::MatrixXd& signals,
                                                    const inverse::MarkerPlacement& placement) const {
        const setup::Setup setup = with_signals_of(signals);
        prediction::TrialPrediction prediction = prediction::predict_trial(
            setup, trial_, prediction::placed_values(setup, placement), {}, progress_.with_sink({}));
        if (prediction.status == dynamics::RunStatus::cancelled) return std::nullopt;
        return with_prediction(setup, std::move(prediction), placement);
    }

    const setup::Setup& setup_;
    std::size_t trial_;
    const inverse::ActuationProblem& problem_;
    Eigen::MatrixXd start_;
    const ui::commands::Settings& settings_;
    const Progress& progress_;
    const ui::commands::Backend::LiveSearch& live_;
    ui::commands::SearchView view_;
    Eigen::MatrixXd shown_;  // signals of view_.best
    Pace pace_;
};

/// The best values so far, as rows and as settings.
void show_values(ui::commands::SearchView& view, const setup::Setup& setup,
                 const std::vector<prediction::ModelParameter>& parameters, const prediction::ParameterValues& declared,
                 const prediction::ParameterValues& values, const ui::commands::Settings& settings) {
    view.parameters.clear();
    for (const prediction::ModelParameter& p : parameters)
        view.parameters.push_back(
            parameter_row(p, setup, prediction::value_of(p, declared), prediction::value_of(p, values), nothing_known));
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
    if (const Result<void> in_seconds = check::require_time_unit(*setup, on_units); !in_seconds)
        return in_seconds.error();
    if (!chosen.h_s) check::choose_declared_steps(*setup, on_units, progress);
    setup::check_integration(*setup);
    return setup;
}

/// Rows of the fitted values, with standard deviations; the live rows have none.
std::vector<ui::commands::ParameterRow> fitted_rows(const setup::Setup& setup,
                                                    const calibration::Calibration& calibration) {
    std::vector<ui::commands::ParameterRow> rows;
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        rows.push_back(parameter_row(calibration.parameters[i], setup, calibration.fit.start(k),
                                     calibration.fit.values(k), calibration.deviation(i)));
    }
    return rows;
}

/// The fitted values as settings.
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
    result.evaluations = calibration.fit.evaluations;
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

calibration::OptimizeSettings optimize_settings(const ui::commands::OptimizeRequest& request, double h_s) {
    calibration::OptimizeSettings how;
    // At most one knot per time step.
    how.frequency_Hz = std::min(request.frequency_Hz, 1.0 / h_s);
    how.lowest = request.lowest;
    how.highest = request.highest;
    how.max_evaluations = request.max_evaluations;
    return how;
}

/// Values, errors and settings that a search for signals has found. `h_s`: step that it used.
ui::commands::SearchResult optimized(const setup::Setup& setup, const inverse::ActuationProblem& problem,
                                     const calibration::Optimization& found, const ui::commands::Settings& settings,
                                     const std::string& trial, double h_s) {
    ui::commands::SearchResult result;
    result.title = "Optimised";
    result.settings = with_signals(settings, inverse::commands_of(problem.sought, found.fit.values));
    if (!settings.own_step) result.settings.time_step_s = h_s;
    result.evaluations = static_cast<int>(found.fit.log.size());
    result.stopped = found.stopped;
    result.warnings = found.warnings;
    if (!found.fit.converged() && !found.stopped) result.problem = "The search did not converge: " + found.fit.message;
    result.parameters = signal_rows(setup, problem, found.fit.start, found.fit.values);
    for (ui::commands::ParameterRow& row : result.parameters) row.deviation = nothing_known;
    if (!setup.experiment.muscles.empty())
        result.notes = {"Signals follow " + trial + "; the muscles use them in all trials now."};
    if (problem.sought.groups.size() > setup.experiment.muscles.size())
        result.notes.emplace_back(
            "Chambers and tendons keep the commands of the trials; the report shows those found.");
    result.rms_before_m = found.before.fit_rms_m;
    result.rms_after_m = found.after.fit_rms_m;
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
    how.evaluated = [&](const calibration::CalibrationStep& step) {
        view.log.push_back(std::isfinite(step.cost)
                               ? ui::commands::SearchPoint{step.cost, step.rms_m, step.gradient_norm}
                               : ui::commands::SearchPoint{});
        if (step.best) {
            show_values(view, *setup, parameters, declared, step.values, settings);
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

Result<ui::commands::SearchResult> optimize_scene(const ui::commands::Scene& scene,
                                                  const ui::commands::MeshedBody& body,
                                                  const ui::commands::Settings& settings,
                                                  const ui::commands::OptimizeRequest& request,
                                                  const Progress& progress,
                                                  const ui::commands::Backend::LiveSearch& live) {
    Result<setup::Setup> setup = scene_setup(scene, body, settings, setup_settings(settings), progress);
    if (!setup) return setup.error();
    setup::check_integration(*setup);
    // A step that the user did not set may be shortened to suit the signals.
    if (!settings.own_step) setup->settings.h_s.reset();
    const Result<std::size_t> trial = prediction::find_trial(setup->experiment, request.trial);
    if (!trial) return trial.error();
    setup::Setup one = prediction::with_one_trial(*setup, *trial);
    calibration::OptimizeSettings how = optimize_settings(request, one.trials.front().options.h_s);
    const Result<inverse::ActuationProblem> problem = calibration::actuation_problem(one, how);
    if (!problem) return problem.error();
    const Eigen::MatrixXd start = drawn_values(one, *problem);
    LiveOptimization shown(*setup, *trial, *problem, start, settings, progress, live);
    how.evaluated = [&](const inverse::ActuationFit& fit) { shown.show(fit); };
    const calibration::Optimization found = calibration::optimize_with_chosen_steps(one, *problem, how, start,
                                                                                    progress);
    if (!found.usable())
        return Error{found.stopped ? "stopped before the first evaluation was complete" : found.fit.message, ""};
    setup::set_step(setup->trials[*trial], one.trials.front().options.h_s);  // displayed with the step that was used
    ui::commands::SearchResult result = optimized(*setup, *problem, found, settings, request.trial,
                                                  one.trials.front().options.h_s);
    result.run = shown.found(found.fit);
    if (!found.stopped) {
        const prediction::SetupRun moved = calibration::run_with_found_signals(one, found, progress);
        result.run.checks = check_rows(check::check_after({.setup = one, .run = &moved}));
    }
    if (result.run.trials[*trial].frames.empty())
        result.warnings.push_back(
            "The search was stopped before the body was run with its best signals; Run shows it.");
    result.run.seconds = found.seconds;
    result.page = std::make_shared<const report::HtmlReport>(
        results::optimize_report(one, found, {MYOLOOP_VERSION, {"workbench"}}));
    return result;
}

}  // namespace myo::backend
