#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "backend/body_actuators.hpp"
#include "backend/check_rows.hpp"
#include "backend/core_scene.hpp"
#include "backend/core_search.hpp"
#include "backend/declaration.hpp"
#include "backend/found_commands.hpp"
#include "backend/found_design.hpp"
#include "backend/search_pace.hpp"
#include "backend/shown_run.hpp"
#include "base/stopwatch.hpp"
#include "calibration/optimize.hpp"
#include "calibration/sought_signals.hpp"
#include "check/catalogue.hpp"
#include "experiment/actuators.hpp"
#include "prediction/trial_goals.hpp"
#include "prediction/trial_target.hpp"
#include "results/optimize_output.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::backend {
namespace {

/// Signals drawn by the user, sampled at the unknown knots and limited to their bounds: the start of the search.
///
/// @return  signals x knots, in the unit of each signal
Eigen::MatrixXd drawn_values(const setup::Setup& setup, const inverse::ActuationProblem& problem) {
    // Only the shape of the matrix is used; every entry is overwritten below.
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

/// The settings with the found signals in place of the drawn ones. Those of chambers and tendons are declared, not set.
ui::commands::Settings with_found_signals(ui::commands::Settings settings, const inverse::SoughtSignals& sought,
                                          const Eigen::MatrixXd& values) {
    // Muscles come first.
    const std::vector<fibre::Signal> activation = calibration::found_commands(sought, values);
    for (std::size_t m = 0; m < settings.muscles.size() && m < activation.size(); ++m)
        // A follower has no signal of its own: the signal of its leader determines it.
        if (settings.muscles[m].follows.empty() && !sought.groups[m].own) settings.muscles[m].signal = activation[m];
    return settings;
}

/// Smallest and largest value of each signal, at the start and now, in shown units.
///
/// @param start, values  signals x knots, SI
std::vector<ui::commands::ParameterRow> signal_rows(const setup::Setup& setup, const inverse::ActuationProblem& problem,
                                                    const Eigen::MatrixXd& start, const Eigen::MatrixXd& values) {
    std::vector<ui::commands::ParameterRow> rows;
    for (std::size_t s = 0; s < problem.sought.signals.size(); ++s) {
        const auto row = static_cast<Eigen::Index>(s);
        const std::string& name = problem.sought.signals[s].name;
        const experiment::Actuator actuator = experiment::actuators(
            setup.experiment)[*experiment::find_actuator(setup.experiment, name)];
        const bool muscle = actuator.kind == experiment::ActuatorKind::muscle;
        const ui::commands::ShownCommand shown = shown_unit(actuator);  // as the signals are drawn
        // SI to shown unit; `per_unit` is SI per shown unit.
        const double factor = 1.0 / shown.per_unit;
        const std::string word = muscle ? "a" : experiment::quantity_word(actuator.kind);
        rows.push_back({name + ", minimum " + word, shown.unit, factor * start.row(row).minCoeff(),
                        factor * values.row(row).minCoeff(), std::numeric_limits<double>::quiet_NaN()});
        rows.push_back({name + ", maximum " + word, shown.unit, factor * start.row(row).maxCoeff(),
                        factor * values.row(row).maxCoeff(), std::numeric_limits<double>::quiet_NaN()});
    }
    return rows;
}

/// Displays a running search for signals. The references given to the constructor must outlive the object.
class LiveOptimization {
public:
    LiveOptimization(const setup::Setup& setup, std::size_t trial, const inverse::ActuationProblem& problem,
                     const calibration::BodyDesign& design, Eigen::MatrixXd start,
                     const ui::commands::Settings& settings, const Progress& progress,
                     const ui::commands::Backend::LiveSearch& live)
        : setup_(setup),
          trial_(trial),
          problem_(problem),
          design_(design),
          start_(std::move(start)),
          settings_(settings),
          progress_(progress),
          live_(live) {
        // The loss is in m²; in mm² its size is readable, hence the factors 1e6 in show().
        view_.loss_unit = "mm\xc2\xb2";
        const bool goals = !setup.experiment.trials[trial].goals.empty();
        view_.target = (goals ? "goals of trial " : "recording of trial ") + setup.trials[trial].name;
    }

    /// Receives every evaluation of the search, on its thread; passes a copy of the view on.
    void show(const inverse::ActuationFit& fit) {
        const inverse::ActuationIterate& line = fit.log.back();
        // A failed evaluation is an empty point, so that the count of evaluations stays right.
        view_.log.push_back(line.ok
                                ? ui::commands::SearchPoint{1e6 * line.loss_m2, line.rms_m, 1e6 * line.gradient_norm_m2}
                                : ui::commands::SearchPoint{});
        if (fit.usable()) {
            view_.parameters = signal_rows(setup_, problem_, start_, fit.values);
            for (ui::commands::ParameterRow& row : design_rows(calibration::found_items(setup_, design_, fit.design)))
                view_.parameters.push_back(std::move(row));
            view_.settings = settings_;
            if (!problem_.sought.signals.empty())
                view_.settings = with_found_signals(settings_, problem_.sought, fit.values);
            // Only an evaluation that is the best so far changes the picture.
            if (line.ok && line.loss_m2 == fit.best.loss_m2 && pace_.due()) {
                // The iterate holds the motion of the marker nodes only; the picture needs a run of the whole body.
                const Stopwatch watch;
                if (auto run = run_with(fit))
                    view_.best = std::make_shared<const ui::commands::RunResult>(std::move(*run)), shown_ = fit.values,
                    shown_design_ = fit.design;
                pace_.took(watch.seconds());
            }
        }
        if (live_) live_(std::make_shared<const ui::commands::SearchView>(view_));
    }

    /// The trial with the final signals. After a cancellation, only the part of the motion that is already known.
    ui::commands::RunResult found(const inverse::ActuationFit& fit) const {
        // The last displayed run is reused if it has the final signals.
        if (view_.best && shown_ == fit.values && shown_design_ == fit.design) return *view_.best;
        if (auto run = run_with(fit)) return std::move(*run);
        // What is left after a cancellation: the markers of the best evaluation, without frames of the body.
        return with_prediction(with_found(fit),
                               prediction::prediction_of(setup_, trial_, fit.best.motion, fit.best.placement),
                               fit.best.placement);
    }

private:
    /// The setup with what was found in all trials.
    setup::Setup with_found(const inverse::ActuationFit& fit) const {
        // The body's design comes first: driven_model() keeps the body of the model that it is given.
        setup::Setup setup = calibration::with_design(setup_, problem_.design, fit.design);
        if (problem_.sought.signals.empty()) return setup;
        for (setup::PreparedTrial& trial : setup.trials)
            trial.model = inverse::driven_model(std::move(trial.model),
                                                calibration::found_commands(problem_.sought, fit.values));
        return setup;
    }

    /// Displayable run from the prediction of the one trial, with the found marker placement.
    ui::commands::RunResult with_prediction(const setup::Setup& setup, prediction::TrialPrediction prediction,
                                            const inverse::MarkerPlacement& placement) const {
        // All other trials stay "not run".
        std::vector<prediction::TrialPrediction> predictions(setup.trials.size());
        predictions[trial_] = std::move(prediction);
        return shown_run(setup, prediction::scored_run(setup, prediction::placed_values(setup, placement),
                                                       std::move(predictions), {trial_}));
    }

    /// Simulates the trial with the best values; empty if cancelled.
    std::optional<ui::commands::RunResult> run_with(const inverse::ActuationFit& fit) const {
        const setup::Setup setup = with_found(fit);
        const inverse::MarkerPlacement& placement = fit.best.placement;
        prediction::TrialPrediction prediction = prediction::predict_trial(
            setup, trial_, prediction::placed_values(setup, placement), {}, progress_.with_sink({}));
        if (prediction.status == dynamics::RunStatus::cancelled) return std::nullopt;
        return with_prediction(setup, std::move(prediction), placement);
    }

    const setup::Setup& setup_;
    std::size_t trial_;
    const inverse::ActuationProblem& problem_;
    const calibration::BodyDesign& design_;
    Eigen::MatrixXd start_;
    const ui::commands::Settings& settings_;
    const Progress& progress_;
    const ui::commands::Backend::LiveSearch& live_;
    ui::commands::SearchView view_;
    Eigen::MatrixXd shown_;         // signals of view_.best
    Eigen::VectorXd shown_design_;  // its values of the design
    Pace pace_;
};

/// Settings of the search from the request of the window. Errors: an unknown word of `seek`; nothing is sought.
///
/// @param h_s  time step of the trial [s]
Result<calibration::OptimizeSettings> optimize_settings(const ui::commands::OptimizeRequest& request,
                                                        const experiment::Experiment& experiment, double h_s) {
    calibration::OptimizeSettings how;
    std::vector<std::string> words = request.seek;
    // A default SoughtItem stands for the signals.
    if (request.signals) words.insert(words.begin(), calibration::to_string({}));
    Result<std::vector<calibration::SoughtItem>> seek = calibration::sought_items(words, experiment);
    if (!seek) return seek.error();
    if (seek->empty()) return Error{"nothing is ticked that the search may change", ""};
    how.seek = *std::move(seek);
    // At most one knot per time step: actuation_problem() refuses knots closer than steps.
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
    // A search of the body alone leaves the drawn signals as they are.
    result.settings = settings;
    const bool signals = !problem.sought.signals.empty();
    if (signals) result.settings = with_found_signals(settings, problem.sought, found.fit.values);
    if (!settings.own_step) result.settings.time_step_s = h_s;
    result.evaluations = found.evaluations();
    result.stopped = found.stopped;
    result.warnings = found.warnings;
    if (!found.fit.converged() && !found.stopped) result.problem = "The search did not converge: " + found.fit.message;
    result.parameters = signal_rows(setup, problem, found.fit.start, found.fit.values);
    for (ui::commands::ParameterRow& row : design_rows(found.found)) result.parameters.push_back(std::move(row));
    // Settings hold one signal per muscle for all trials, which replaces those that other trials recorded.
    const auto muscles = problem.sought.groups.begin() + static_cast<std::ptrdiff_t>(setup.experiment.muscles.size());
    if (std::any_of(problem.sought.groups.begin(), muscles, [](const auto& group) { return !group.own; }))
        result.notes = {(found.miss.goals ? "Signals follow the goals of " : "Signals follow ") + trial +
                        "; the muscles use them in all trials now."};
    result.rms_before_m = found.before.fit_rms_m;
    result.rms_after_m = found.after.fit_rms_m;
    return result;
}

/// Declares the commands found for chambers and tendons in the experiment, or says why they stay.
///
/// @param trial   index in the experiment, whose commands are replaced
/// @param result  its declaration and notes are changed
/// Errors: those of edited_declaration().
Result<void> state_commands(const ui::commands::Scene& scene, std::size_t trial,
                            const inverse::ActuationProblem& problem, const inverse::ActuationFit& fit,
                            ui::commands::SearchResult& result) {
    const experiment::Experiment& experiment = source_of(scene).experiment;
    if (problem.sought.signals.empty() || experiment.chambers.size() + experiment.tendons.size() == 0) return {};
    // found_commands() lists muscles first, then chambers and tendons.
    const std::vector<fibre::Signal> all = calibration::found_commands(problem.sought, fit.values);
    std::vector<std::optional<fibre::Signal>> commands;
    for (std::size_t g = all.size() - experiment.chambers.size() - experiment.tendons.size(); g < all.size(); ++g)
        commands.push_back(problem.sought.groups[g].own ? std::nullopt : std::optional(all[g]));
    if (std::none_of(commands.begin(), commands.end(), [](const auto& command) { return command.has_value(); }))
        return {};
    const std::vector<ui::commands::DeclarationEdit> edits = found_command_edits(experiment, trial, commands);
    if (edits.empty()) {
        result.notes.emplace_back(
            "Chambers and tendons keep the recorded commands of the trial; the report shows those found.");
        return {};
    }
    Result<ui::commands::Declaration> declared = edited_declaration(scene, result.settings.declaration, edits);
    if (!declared) return declared.error();
    result.settings.declaration = *std::move(declared);
    result.notes.emplace_back("Commands of chambers and tendons stand in the trial now, as curves over time.");
    return {};
}

}  // namespace

Result<ui::commands::SearchResult> optimize_scene(const ui::commands::Scene& scene,
                                                  const ui::commands::MeshedBody& body,
                                                  const ui::commands::Settings& settings,
                                                  const ui::commands::OptimizeRequest& request,
                                                  const Progress& progress,
                                                  const ui::commands::Backend::LiveSearch& live) {
    // Material, muscles and effects are those of the window, not of the file.
    Result<setup::Setup> setup = scene_setup(scene, body, settings, setup_settings(settings), progress);
    if (!setup) return setup.error();
    setup::check_integration(*setup);
    // A step that the user did not set may be shortened to suit the signals.
    if (!settings.own_step) setup->settings.h_s.reset();
    const Result<std::size_t> trial = prediction::find_trial(setup->experiment, request.trial);
    if (!trial) return trial.error();
    Result<calibration::OptimizeSettings> how = optimize_settings(request, setup->experiment,
                                                                  setup->trials[*trial].options.h_s);
    if (!how) return how.error();
    // body_design() replaces the fibres of painted muscles in the setup, so the single trial is taken from it
    // afterwards.
    const Result<calibration::BodyDesign> design = calibration::body_design(*setup, how->seek);
    if (!design) return design.error();
    Result<setup::Setup> target = prediction::with_goals(prediction::with_one_trial(*setup, *trial));
    if (!target) return target.error();
    // Two setups from here on: `one` is the target of the search, `setup` has all trials for display.
    setup::Setup& one = *target;
    const Result<inverse::ActuationProblem> problem = calibration::actuation_problem(one, *how, design->variables);
    if (!problem) return problem.error();
    const Eigen::MatrixXd start = drawn_values(one, *problem);
    LiveOptimization shown(*setup, *trial, *problem, *design, start, settings, progress, live);
    how->evaluated = [&](const inverse::ActuationFit& fit) { shown.show(fit); };
    calibration::Optimization found = calibration::optimize_with_chosen_steps(one, *problem, *how, start, progress);
    if (!found.usable())
        return Error{found.stopped ? "stopped before the first evaluation was complete" : found.fit.message, ""};
    found.found = calibration::found_items(one, *design, found.fit.design);
    setup::set_step(setup->trials[*trial], one.trials.front().options.h_s);  // displayed with the step that was used
    ui::commands::SearchResult result = optimized(*setup, *problem, found, settings, request.trial,
                                                  one.trials.front().options.h_s);
    Result<ui::commands::Settings> designed = with_found_design(std::move(result.settings), scene, found.found);
    if (!designed) return designed.error();
    result.settings = *std::move(designed);
    // After with_found_design(), which may have edited the declaration already: both edits must be kept.
    if (const Result<void> stated = state_commands(scene, *trial, *problem, found.fit, result); !stated)
        return stated.error();
    result.run = shown.found(found.fit);
    if (!found.stopped) {
        // Checks of recordings have nothing to say about goals.
        const setup::Setup checked = prediction::without_goals(one);
        const prediction::SetupRun moved = calibration::run_with_found_signals(checked, found, progress);
        result.run.checks = check_rows(check::check_after({.setup = checked, .run = &moved}));
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
