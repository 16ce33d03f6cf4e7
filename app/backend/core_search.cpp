#include "backend/core_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "backend/check_rows.hpp"
#include "backend/core_scene.hpp"
#include "backend/shown_run.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "check/declared_steps.hpp"
#include "project/calibrate_study.hpp"
#include "project/time_step.hpp"
#include "project/optimize_study.hpp"
#include "project/readable_parameter.hpp"
#include "project/study_report.hpp"
#include "project/study_target.hpp"
#include "project/untested_fit.hpp"

namespace myo {
namespace {

constexpr double nothing_known = std::numeric_limits<double>::quiet_NaN();

ParameterRow parameter_row(const StudyParameter& parameter, const Study& study, double start, double value, double deviation) {
    const ReadableParameter shown = readable_parameter(parameter, study);
    return {shown.name, shown.unit, shown.factor * start, shown.factor * value, shown.factor * deviation};
}

/// Decides when the best so far is shown again: the pictures shall cost no more than a fifth of the time.
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

/// A run of the trials whose predictions are there.
std::shared_ptr<const RunResult> run_of(const Study& study, const StudyValues& values, const std::vector<std::size_t>& trials, const std::vector<TrialPrediction>& predictions) {
    std::vector<TrialPrediction> all(study.trials.size());
    for (std::size_t i = 0; i < trials.size(); ++i) all[trials[i]] = predictions[i];
    return std::make_shared<const RunResult>(shown_run(study, scored_run(study, values, std::move(all), trials)));
}

std::vector<std::size_t> fit_trials(const Study& study) {
    std::vector<std::size_t> trials;
    for (std::size_t t = 0; t < study.trials.size(); ++t)
        if (study.trials[t].role == TrialRole::fit) trials.push_back(t);
    return trials;
}

/// Signals as drawn, at the knots that are looked for.
Eigen::MatrixXd drawn_values(const Study& study, const ActuationProblem& problem) {
    Eigen::MatrixXd values = unmoved_values(problem.sought);
    const std::vector<double> times = knot_times(problem.sought);
    for (std::size_t m = 0; m < problem.sought.groups.size(); ++m) {
        const SignalShare& share = problem.sought.groups[m];
        const auto row = static_cast<Eigen::Index>(share.signal);
        const SoughtSignal& signal = problem.sought.signals[share.signal];
        if (study.experiment.muscles[m].name != signal.name) continue;   // one that follows
        for (Eigen::Index k = 0; k < values.cols(); ++k)
            values(row, k) = std::clamp(study.trials.front().model.activation[m].value(times[static_cast<std::size_t>(k)]), signal.lower, signal.upper);
    }
    return values;
}

/// The settings with signals in the place of those that were drawn.
Settings with_signals(Settings settings, const std::vector<Signal>& activation) {
    for (std::size_t m = 0; m < settings.muscles.size() && m < activation.size(); ++m)
        if (settings.muscles[m].follows.empty()) settings.muscles[m].signal = activation[m];
    return settings;
}

std::vector<ParameterRow> signal_rows(const ActuationProblem& problem, const Eigen::MatrixXd& start, const Eigen::MatrixXd& values) {
    std::vector<ParameterRow> rows;
    for (std::size_t s = 0; s < problem.sought.signals.size(); ++s) {
        const auto row = static_cast<Eigen::Index>(s);
        rows.push_back({problem.sought.signals[s].name + ", least a", "", start.row(row).minCoeff(), values.row(row).minCoeff(), nothing_known});
        rows.push_back({problem.sought.signals[s].name + ", greatest a", "", start.row(row).maxCoeff(), values.row(row).maxCoeff(), nothing_known});
    }
    return rows;
}

/// A search for signals, shown while it goes on.
class LiveOptimization {
public:
    LiveOptimization(const Study& study, std::size_t trial, const ActuationProblem& problem, Eigen::MatrixXd start, const Settings& settings, const Progress& progress,
                     const Backend::LiveSearch& live)
        : study_(study), trial_(trial), problem_(problem), start_(std::move(start)), settings_(settings), progress_(progress), live_(live) {
        view_.loss_unit = "mm\xc2\xb2";
    }

    void show(const ActuationFit& fit) {
        const ActuationIterate& line = fit.log.back();
        view_.log.push_back(line.ok ? SearchPoint{1e6 * line.loss_m2, line.rms_m, 1e6 * line.gradient_norm_m2} : SearchPoint{});
        if (fit.usable()) {
            const std::vector<Signal> activation = activations_of(problem_.sought, fit.values);
            view_.parameters = signal_rows(problem_, start_, fit.values);
            view_.settings = with_signals(settings_, activation);
            if (line.ok && line.loss_m2 == fit.best.loss_m2 && pace_.due()) {
                const Stopwatch watch;
                if (auto run = run_with(fit.values, fit.best.placement))
                    view_.best = std::make_shared<const RunResult>(std::move(*run)), shown_ = fit.values;
                pace_.took(watch.seconds());
            }
        }
        if (live_) live_(std::make_shared<const SearchView>(view_));
    }

    /// The trial with the signals that were found. Where the search was stopped, no more of the motion than is known by then.
    RunResult found(const ActuationFit& fit) const {
        if (view_.best && shown_.size() > 0 && shown_ == fit.values) return *view_.best;
        if (auto run = run_with(fit.values, fit.best.placement)) return std::move(*run);
        return with_prediction(with_signals_of(fit.values),
                               prediction_of(study_, trial_, fit.best.motion, fit.best.placement), fit.best.placement);
    }

private:
    Study with_signals_of(const Eigen::MatrixXd& found) const {
        Study study = study_;
        for (StudyTrial& trial : study.trials) trial.model.activation = activations_of(problem_.sought, found);
        return study;
    }

    RunResult with_prediction(const Study& study, TrialPrediction prediction, const MarkerPlacement& placement) const {
        std::vector<TrialPrediction> predictions(study.trials.size());
        predictions[trial_] = std::move(prediction);
        return shown_run(study, scored_run(study, placed_values(study, placement), std::move(predictions), {trial_}));
    }

    /// The trial run with these signals; empty when it was cancelled.
    std::optional<RunResult> run_with(const Eigen::MatrixXd& signals, const MarkerPlacement& placement) const {
        const Study study = with_signals_of(signals);
        TrialPrediction prediction =
            predict_trial(study, trial_, placed_values(study, placement), {}, progress_.with_sink({}));
        if (prediction.status == RunStatus::cancelled) return std::nullopt;
        return with_prediction(study, std::move(prediction), placement);
    }

    const Study& study_;
    std::size_t trial_;
    const ActuationProblem& problem_;
    Eigen::MatrixXd start_;
    const Settings& settings_;
    const Progress& progress_;
    const Backend::LiveSearch& live_;
    SearchView view_;
    Eigen::MatrixXd shown_;   // signals with which view_.best moves
    Pace pace_;
};

}  // namespace

Result<SearchResult> calibrate_scene(const Scene& scene, const MeshedBody& body, const Settings& settings, const Progress& progress, const Backend::LiveSearch& live) {
    StudySettings chosen = study_settings(settings);
    // A step that nobody set gives way to one that suits the fit.
    if (!settings.own_step) chosen.h_s.reset();
    Result<Study> study = scene_study(scene, body, settings, chosen, progress);
    if (!study) return study.error();
    const std::optional<std::string> untested = untested_fit(*study);
    if (untested) study->warnings.push_back(*untested);
    if (!chosen.h_s) choose_declared_steps(*study, findings_on_units(*study), progress);
    check_integration(*study);
    const std::vector<StudyParameter> parameters = study_parameters(*study);
    const StudyValues declared = declared_values(*study);
    SearchView view;
    Pace pace;
    CalibrationSettings how;
    how.evaluated = [&](const CalibrationStep& step) {
        view.log.push_back(std::isfinite(step.cost) ? SearchPoint{step.cost, step.rms_m, step.gradient_norm} : SearchPoint{});
        if (step.best) {
            view.parameters.clear();
            for (const StudyParameter& p : parameters) view.parameters.push_back(parameter_row(p, *study, value_of(p, declared), value_of(p, step.values), nothing_known));
            view.settings = settings;
            view.settings.youngs_modulus_Pa = step.values.youngs_modulus_Pa;
            view.settings.damping_s = step.values.damping_s;
            if (pace.due()) {
                const Stopwatch watch;
                view.best = run_of(*study, step.values, fit_trials(*study), *step.best);
                pace.took(watch.seconds());
            }
        }
        if (live) live(std::make_shared<const SearchView>(view));
    };
    const Calibration calibration = calibrate_with_chosen_steps(*study, how, progress);
    if (!calibration.usable()) return Error{calibration.fit.message, ""};
    SearchResult result;
    result.title = "Calibrated";
    result.settings = settings;
    result.evaluations = calibration.fit.evaluations;
    result.stopped = calibration.stopped;
    result.warnings = calibration.warnings;
    if (untested) result.warnings.push_back(*untested);
    RunFacts facts{MYOLOOP_VERSION, {"workbench"}};
    const std::vector<TrialStep> seen = steps_seen_in(*study, calibration.after);
    facts.findings =
        check_after({.study = *study, .run = &calibration.after, .calibration = &calibration, .seen = &seen});
    if (!calibration.fit.converged() && !calibration.stopped) result.problem = "The fit did not converge: " + calibration.fit.message;
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        result.parameters.push_back(parameter_row(calibration.parameters[i], *study, calibration.fit.start(k),
                                                 calibration.fit.values(k), calibration.deviation(i)));
    }
    result.rms_before_m = calibration.before.fit_rms_m;
    result.rms_after_m = calibration.after.fit_rms_m;
    result.settings.youngs_modulus_Pa = calibration.after.values.youngs_modulus_Pa;
    result.settings.damping_s = calibration.after.values.damping_s;
    if (!settings.own_step) result.settings.time_step_s = shortest_step_s(*study);
    result.run = shown_run(*study, calibration.after);
    add_vibrations(seen, result.run);
    result.run.checks = check_rows(facts.findings);
    result.run.seconds = calibration.seconds;
    result.page = std::make_shared<const HtmlReport>(study_report(*study, calibration, facts));
    return result;
}

Result<SearchResult> optimize_scene(const Scene& scene, const MeshedBody& body, const Settings& settings, const OptimizeRequest& request, const Progress& progress,
                                    const Backend::LiveSearch& live) {
    Result<Study> study = scene_study(scene, body, settings, study_settings(settings), progress);
    if (!study) return study.error();
    check_integration(*study);
    // A step that nobody set gives way to a shorter one that suits the signals.
    if (!settings.own_step) study->settings.h_s.reset();
    const Result<std::size_t> trial = find_trial(study->experiment, request.trial);
    if (!trial) return trial.error();
    Study one = with_one_trial(*study, *trial);
    OptimizeSettings how;
    how.frequency_Hz = std::min(request.frequency_Hz, 1.0 / one.trials.front().options.h_s);
    how.lowest = request.lowest;
    how.highest = request.highest;
    how.max_evaluations = request.max_evaluations;
    const Result<ActuationProblem> problem = actuation_problem(one, how);
    if (!problem) return problem.error();
    const Eigen::MatrixXd start = drawn_values(one, *problem);
    LiveOptimization shown(*study, *trial, *problem, start, settings, progress, live);
    how.evaluated = [&](const ActuationFit& fit) { shown.show(fit); };
    const Optimization found = optimize_with_chosen_steps(one, *problem, how, start, progress);
    if (!found.usable()) return Error{found.stopped ? "stopped before the first evaluation was complete" : found.fit.message, ""};
    set_step(study->trials[*trial], one.trials.front().options.h_s);   // the body is shown as it was run
    SearchResult result;
    result.title = "Optimised";
    result.settings = with_signals(settings, activations_of(problem->sought, found.fit.values));
    if (!settings.own_step) result.settings.time_step_s = one.trials.front().options.h_s;
    result.evaluations = static_cast<int>(found.fit.log.size());
    result.stopped = found.stopped;
    result.warnings = found.warnings;
    if (!found.fit.converged() && !found.stopped) result.problem = "The search did not converge: " + found.fit.message;
    result.parameters = signal_rows(*problem, found.fit.start, found.fit.values);
    for (ParameterRow& row : result.parameters) row.deviation = nothing_known;
    result.notes = {"Signals follow " + request.trial + "; they are those of the muscles now, in all trials."};
    result.rms_before_m = found.before.fit_rms_m;
    result.rms_after_m = found.after.fit_rms_m;
    result.run = shown.found(found.fit);
    if (!found.stopped) {
        const StudyRun moved = run_with_found_signals(one, found, progress);
        result.run.checks = check_rows(check_after({.study = one, .run = &moved}));
    }
    if (result.run.trials[*trial].frames.empty()) result.warnings.push_back("The search was stopped before the body was run with its best signals; Run shows it.");
    result.run.seconds = found.seconds;
    result.page = std::make_shared<const HtmlReport>(optimize_report(one, found, {MYOLOOP_VERSION, {"workbench"}}));
    return result;
}

}  // namespace myo
