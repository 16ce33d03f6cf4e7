#include "calibration/optimize.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <random>

#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "calibration/sought_signals.hpp"
#include "effect/catalogue.hpp"
#include "experiment/read_experiment.hpp"
#include "prediction/trial_goals.hpp"
#include "prediction/trial_target.hpp"
#include "setup/actuator_signals.hpp"
#include "setup/trial_effects.hpp"

namespace myo::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// What the declared effects make of the commanded signals; null without effects on the actuation.
inverse::ActingSignals acting_signals(const setup::Setup& setup) {
    std::vector<effect::EffectDeclaration> effects;
    for (const effect::EffectDeclaration& effect : setup.experiment.effects)
        if (effect::find_effect(effect)->kind == effect::EffectKind::actuation) effects.push_back(effect);
    if (effects.empty()) return nullptr;
    // The function outlives this call, so it keeps a copy of the setup.
    return [kept = std::make_shared<const setup::Setup>(setup), effects](const std::vector<fibre::Signal>& commanded) {
        const model::Model acting = setup::with_effects(
                                        *kept, 0, inverse::driven_model(kept->trials.front().model, commanded), effects)
                                        .model;
        std::vector<fibre::Signal> signals;
        for (std::size_t i = 0; i < commanded.size(); ++i)
            signals.push_back(setup::actuator_signal(kept->experiment, acting, i));
        return signals;
    };
}

/// Last time at which a marker is visible [s]; 0 if none is visible after the start.
double last_seen(const inverse::MarkerTarget& target) {
    for (Index t = target.times_s.size() - 1; t >= 0; --t)
        for (const Eigen::Matrix3Xd& track : target.positions_m)
            if (track.col(t).array().isFinite().any()) return std::max(0.0, target.times_s(t));
    return 0.0;
}

/// Constant random signals within 0.3 scales of passive and the bounds.
MatrixXd random_values(const inverse::SoughtSignals& sought, std::mt19937_64& random) {
    MatrixXd values = inverse::unmoved_values(sought);
    for (Index s = 0; s < values.rows(); ++s) {
        const inverse::SoughtSignal& signal = sought.signals[static_cast<std::size_t>(s)];
        const double low = std::max(signal.passive - 0.3 * signal.scale, signal.lower),
                     high = std::min(signal.passive + 0.3 * signal.scale, signal.upper);
        // Top 53 bits of the generator: std::uniform_real_distribution differs between standard libraries.
        values.row(s).setConstant(
            std::clamp(low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53, signal.lower, signal.upper));
    }
    return values;
}

/// One sentence per signal of which values ended at a bound.
std::vector<std::string> bound_warnings(const inverse::SoughtSignals& sought, const MatrixXd& values) {
    std::vector<std::string> warnings;
    for (Index s = 0; s < values.rows(); ++s) {
        const inverse::SoughtSignal& signal = sought.signals[static_cast<std::size_t>(s)];
        const Index stopped = (values.row(s).array() <= signal.lower).count() +
                              (values.row(s).array() >= signal.upper).count();
        if (stopped > 0)
            warnings.push_back(signal.name + ": " + std::to_string(stopped) + " of " + std::to_string(values.cols()) +
                               " values ended at a bound (" + format_number(signal.lower, 4) + ", " +
                               format_number(signal.upper, 4) + ")");
    }
    return warnings;
}

/// The run of an evaluation. The error of goals is weighted as in the loss.
prediction::SetupRun run_of(const setup::Setup& setup, const inverse::ActuationEvaluation& evaluation) {
    prediction::SetupRun run = prediction::scored_run(
        setup, prediction::placed_values(setup, evaluation.placement),
        {prediction::prediction_of(setup, 0, evaluation.motion, evaluation.placement)}, {0});
    if (prediction::follows_goals(setup)) run.fit_rms_m = evaluation.rms_m;
    return run;
}

/// Warnings about the result, most serious first.
std::vector<std::string> warnings_of(const setup::Setup& setup, const Optimization& result) {
    std::vector<std::string> warnings;
    if (!result.miss.reached) warnings.push_back(sentence(result.miss, result.before.fit_rms_m));
    if (const auto start = start_miss(setup, result.problem, result.after)) warnings.push_back(*start);
    const inverse::SoughtSignals& sought = result.problem.sought;
    if (sought.from_before && !sought.seek_before)
        for (const std::string& name : unrecorded_levels(setup, result.settings))
            warnings.push_back("signal " + name +
                               ": its level before t = 0 is on no record, unlike that of others; passive is taken");
    const auto& placed = result.problem.placement_bounds;
    if (placed && inverse::at_bound(result.fit.best.placement, *placed))
        warnings.push_back("registration: the camera frame ended at its bound (" +
                           format_number(1e3 * placed->translation_m, 3) + " mm, " +
                           format_number(placed->rotation_rad * 180.0 / std::numbers::pi, 3) + " degrees)");
    const std::vector<std::string> bounds = bound_warnings(sought, result.fit.values);
    warnings.insert(warnings.end(), bounds.begin(), bounds.end());
    return warnings;
}

/// The problem with a found camera frame, at which its deviations are computed.
inverse::ActuationProblem with_placement(inverse::ActuationProblem problem, const inverse::MarkerPlacement& placement) {
    problem.target.placement = placement;
    return problem;
}

/// Progress under another task name, for runs that are part of a search.
Progress in_task(const Progress& progress, const std::string& task) {
    return progress.with_sink([&progress, task](ProgressEvent event) {
        event.task = task;
        progress.report(event);
    });
}

}  // namespace

bool seeks_signals(const OptimizeSettings& settings) {
    return std::any_of(settings.seek.begin(), settings.seek.end(),
                       [](const SoughtItem& item) { return item.kind == SoughtKind::signals; });
}

bool seeks_signal(const OptimizeSettings& settings, const experiment::Actuator& actuator) {
    return std::any_of(settings.seek.begin(), settings.seek.end(), [&](const SoughtItem& item) {
        return item.kind == SoughtKind::signals && (item.of.empty() ? actuator.sought : item.of == actuator.name);
    });
}

int Optimization::evaluations() const {
    int sum = 0;
    for (const StartEnding& start : starts) sum += start.evaluations;
    return sum;
}

Result<inverse::ActuationProblem> actuation_problem(const setup::Setup& setup, const OptimizeSettings& settings,
                                                    inverse::Design design) {
    assert(setup.trials.size() == 1);
    const setup::PreparedTrial& trial = setup.trials.front();
    const bool signals = seeks_signals(settings);
    if (signals && setup::actuator_names(setup.experiment).empty())
        return experiment::declaration_error(
            setup.experiment, "muscle",
            "no muscle, chamber or tendon is declared, so there is no actuation to be found");
    if (trial.role == experiment::TrialRole::simulate)
        return experiment::declaration_error(setup.experiment, "trial[0].role",
                                             "trial " + trial.name +
                                                 " has neither a recording nor a [[trial.goal]] that the "
                                                 "markers could follow");
    const double lowest = lowest_activation(setup.experiment, settings);
    if (!(lowest < settings.highest)) return Error{"is not below --highest", "--lowest"};
    if (!(lowest > 0.0) && !setup.settings.as_published)
        return Error{"must be above 0: an activation of 1 is passive, and at 0 fibres would contract to nothing",
                     "--lowest"};
    for (const effect::EffectDeclaration& effect : setup.experiment.effects)
        if (setup::changes_observation_only(effect))
            return experiment::declaration_error(
                setup.experiment, "effect",
                "\"" + effect.id +
                    "\" changes what is seen of the motion; signals "
                    "cannot be sought with it: correct the recording, or leave it out");
    inverse::ActuationProblem problem;
    effect::Affected affected = setup::with_effects(setup, 0, trial.model, setup.experiment.effects);
    problem.model = std::move(affected.model);
    problem.options = affected.options;
    problem.acting = acting_signals(setup);
    problem.target = prediction::trial_target(setup, 0, std::numeric_limits<double>::infinity());
    // Signals after the last visible sample are not determined.
    problem.options.end_s = last_seen(problem.target);
    const bool goals = prediction::follows_goals(setup);
    if (!(problem.options.end_s > 0.0) && !trial.hold && goals)
        return experiment::declaration_error(setup.experiment, "trial[0].goal",
                                             "no goal of trial " + trial.name + " lies after its start");
    if (!(problem.options.end_s > 0.0) && !trial.hold)
        return Error{"trial " + trial.name + ": no marker was seen after the start",
                     setup.experiment.trials.front().trace.string()};
    // More than one knot per time step cannot be distinguished by the simulation.
    if (signals && !trial.hold && settings.frequency_Hz * trial.options.h_s > 1.0 + 1e-9)
        return Error{format_number(settings.frequency_Hz) + " Hz asks for more than one knot per step of " +
                         format_number(1e3 * trial.options.h_s, 4) + " ms; choose a lower one or a smaller --dt",
                     "--frequency"};
    problem.sought = sought_signals(setup, settings, problem.options.end_s);
    if (signals && problem.sought.signals.empty())
        return Error{
            "no signal is left to be sought: every actuator is declared with sought = false; name those to be "
            "sought, as in signals:NAME",
            "--seek"};
    for (const inverse::SoughtSignal& signal : problem.sought.signals)
        if (!(signal.lower < signal.upper))
            return Error{
                "muscle " + signal.name + " and those that follow it have no value in common within the bounds",
                "--lowest"};
    const experiment::RegistrationDeclaration& registration = setup.experiment.registration;
    if (!registration.known && registration.method == experiment::RegistrationMethod::limited &&
        !problem.target.from_start)
        problem.placement_bounds = {registration.max_translation_m,
                                    registration.max_rotation_deg * std::numbers::pi / 180.0};
    if (const model::MountMotionPointer mount = prediction::declared_mount(setup, 0)) {
        if (problem.placement_bounds)
            return experiment::declaration_error(setup.experiment, "registration.known",
                                                 "must be true, or rest_pose the method: signals cannot be sought with "
                                                 "a moving mount and an unknown camera frame at once");
        // Displacements are taken in a frame that a turning mount would rotate.
        if (mount->turns() && problem.target.from_start)
            return experiment::declaration_error(setup.experiment, "markers.compare",
                                                 "must be \"position\": signals cannot be sought by displacements "
                                                 "from a mount that turns");
    }
    // Noise times one second: a change of a signal by its scale per second costs as much as one noise level of
    // distance.
    problem.smoothness_m_s = settings.smoothness_m_s.value_or(setup::mean_noise(setup));
    problem.design = std::move(design);
    problem.design_smoothness_m = setup::mean_noise(setup);
    return problem;
}

Optimization search_signals(const setup::Setup& setup, const inverse::ActuationProblem& problem,
                            const OptimizeSettings& settings, const inverse::ActuationStart& start,
                            const Progress& progress) {
    const Stopwatch watch;
    Optimization result;
    result.settings = settings;
    result.problem = problem;
    std::mt19937_64 random(settings.seed);
    std::optional<inverse::ActuationEvaluation> first;  // of the first start that could be run
    double done = 0.0;
    for (int s = 0; s < settings.starts && !progress.cancelled(); ++s) {
        const Progress inner = progress.with_sink([&](const ProgressEvent& event) {
            const std::string words = settings.starts > 1 ? "start " + std::to_string(s + 1) + " of " +
                                                                std::to_string(settings.starts) + "  "
                                                          : "";
            progress.report(
                {event.task, done + event.done, event.total * settings.starts, event.unit, words + event.message});
        });
        inverse::ActuationFitOptions options;
        options.max_evaluations = settings.max_evaluations;
        options.evaluated = settings.evaluated;
        // Below the noise of the recording a smaller loss means nothing, so the search ends.
        options.met_rms_m = TargetRule{}.met * setup::mean_noise(setup);
        inverse::ActuationFit fit = inverse::fit_actuation(
            problem, s == 0 ? start : inverse::ActuationStart(random_values(problem.sought, random)), options, inner);
        done += static_cast<double>(fit.log.size());
        result.starts.push_back(
            {fit.status, fit.message, fit.first.loss_m2, fit.best.loss_m2, static_cast<int>(fit.log.size())});
        if (fit.usable() && !first) first = fit.first;
        const bool better = fit.usable() && (!result.usable() || fit.best.loss_m2 < result.fit.best.loss_m2);
        // Converged at the first evaluation: the start already meets the target, so further starts gain nothing.
        const bool met = fit.usable() && fit.log.size() == 1 && fit.converged();
        if (better || s == 0) result.fit = std::move(fit);
        if (met) break;
    }
    if (first) result.fit.first = std::move(*first);
    result.stopped = progress.cancelled();
    result.seconds = watch.seconds();
    return result;
}

void judge_signals(const setup::Setup& setup, Optimization& result, const Progress& progress) {
    if (!result.usable()) return;
    const Stopwatch watch;
    result.before = run_of(setup, result.fit.first);
    result.after = run_of(setup, result.fit.best);
    result.miss = target_miss(setup, result.after);
    result.warnings = warnings_of(setup, result);
    if (result.stopped)
        result.deviations.reason = "not looked for: the search was stopped";
    else if (!result.problem.design.empty())
        result.deviations.reason = "none: not computed where the body is sought, too";
    else if (prediction::follows_goals(setup))
        result.deviations.reason = "none: goals are no measurements";
    else
        result.deviations = inverse::actuation_deviations(with_placement(result.problem, result.fit.best.placement),
                                                          result.fit.values, setup::mean_noise(setup),
                                                          in_task(progress, "deviations"));
    result.warnings.insert(result.warnings.end(), result.deviations.warnings.begin(), result.deviations.warnings.end());
    result.seconds += watch.seconds();
}

}  // namespace myo::calibration
