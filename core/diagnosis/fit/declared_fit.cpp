#include "diagnosis/fit/declared_fit.hpp"

#include <numeric>
#include <utility>

#include "diagnosis/discretisation/longer_steps.hpp"
#include "diagnosis/discretisation/refinement.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "prediction/predict_trials.hpp"
#include "prediction/runnable_start.hpp"

namespace myo::diagnosis {
namespace {

/// Lengthens the time steps while predictions change by at most max_m [m, rms]. Returns whether a step became longer.
bool lengthen_steps(DeclaredFit& result, double max_m, PhaseLog& log) {
    // A step that the user states is kept.
    if (result.setup.settings.h_s) return false;
    const LongerSteps longer = log.timed("step", 0, [&] {
        return longer_steps(result.setup, prediction::declared_values(result.setup), max_m, log.progress());
    });
    log.add("step", 0.0, longer.runs);
    result.step_factors.resize(longer.factors.size(), 1.0);
    for (std::size_t t = 0; t < longer.factors.size(); ++t) {
        result.step_factors[t] *= longer.factors[t];
        result.setup.trials[t].options.h_s *= longer.factors[t];
    }
    return any_longer(longer.factors);
}

/// Repeated trials, by the declared motion of all.
Repeatability repeats_of(const setup::Setup& setup, const prediction::ParameterValues& declared,
                         const RepeatPolicy& policy, PhaseLog& log) {
    if (setup.trials.size() < 2) return {};
    std::vector<std::size_t> all(setup.trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return log.timed("repeated trials", static_cast<int>(all.size()), [&] {
        return repeatability(setup, prediction::predict_trials_with(setup, declared, all, log.progress()), policy);
    });
}

/// Stops later runs of the fit trials at a multiple of the iterations of this fit.
void limit_iterations(DeclaredFit& result, const JointFit& fit, const DeclaredFitPolicy& policy) {
    for (std::size_t i = 0; i < result.data.trials.size(); ++i)
        result.setup.trials[result.data.trials[i]].options.max_iterations = policy.max_iteration_ratio *
                                                                            fit.predictions[i].trace.newton_iterations;
}

/// Fit of the declared model. With unknown places of the markers these are linearised at the declared values first and
/// at the fitted ones then, where a refit starts; later fits keep that linearisation, and the markers at the places
/// found.
JointFit fit_of_declared(DeclaredFit& result, prediction::ParameterValues start, const DiagnoseSettings& settings,
                         FitStore& store, PhaseLog& log) {
    // Reads `start` at the time of its call: below it changes between the calls.
    const auto fitted = [&](const WarmStart& warm) {
        return logged_fit("declared fit",
                          {result.setup, result.data, start, settings.policy, EffectFreedom::all,
                           settings.policy.declared.effort, warm},
                          store, log);
    };
    if (!(result.setup.experiment.markers.placement_m > 0.0)) return fitted({});
    const std::vector<prediction::TrialPrediction> declared = prediction::predict_trials_with(
        result.setup, start, result.data.trials, log.progress());
    // Where these values cannot be run, the fit says so.
    if (!prediction::all_ok(declared)) return fitted({});
    result.data = with_unknown_places(result.setup, std::move(result.data), declared);
    const JointFit first = fitted({});
    if (!first.usable() || log.cancelled()) return first;
    start = first.values;
    // The derivatives by the places depend on the motion: the second linearisation is at the fitted one.
    start.places_m = probable_places(result.setup, result.data, first.residual);
    std::vector<prediction::TrialPrediction> placed;
    // Moved markers need no new run: they only observe the body elsewhere.
    for (std::size_t i = 0; i < result.data.trials.size(); ++i)
        placed.push_back(
            prediction::observe_trial(result.setup, result.data.trials[i], start, first.predictions[i].trace));
    result.data = with_unknown_places(result.setup, std::move(result.data), placed);
    return fitted({{}, {}, warm_start_of(first).paths});
}

}  // namespace

DeclaredFit fit_declared(const setup::Setup& setup, const DiagnoseSettings& settings, FitStore& store, PhaseLog& log) {
    DeclaredFit result{
        setup, fit_data(setup, prediction::trials_with_role(setup, experiment::TrialRole::fit)), {}, {}, {}, {}, {}};
    if (result.data.layout.size() == 0) {
        result.failure = "no sample of a fit trial can be compared";
        return result;
    }
    const NumericsPolicy& numerics = settings.policy.numerics;
    const double noise_m = setup::mean_noise(setup);
    // Steps first, at the declared values: the time of all later phases is proportional to their number.
    lengthen_steps(result, numerics.max_step_change * noise_m, log);
    if (log.cancelled()) return result;
    const prediction::ParameterValues declared = prediction::declared_values(result.setup);
    result.repeatability = repeats_of(result.setup, declared, settings.policy.repeats, log);
    result.data.floor_m = result.repeatability.rms_m;
    if (log.cancelled()) return result;
    JointFit fit = fit_of_declared(result, declared, settings, store, log);
    if (log.cancelled()) return result;
    // The declared values may be impossible to run while others within the bounds are not.
    if (!fit.usable())
        if (const auto start = prediction::runnable_start(result.setup, declared, fit.parameters, result.data.trials,
                                                          log.progress()))
            fit = fit_of_declared(result, *start, settings, store, log);
    if (!fit.usable()) {
        result.failure = "the declared model cannot be run: " + fit.report.message;
        return result;
    }
    limit_iterations(result, fit, settings.policy.declared);
    // Where even the best declared model leaves much, a step error well below that is harmless.
    const double left_m = numerics.step_change_of_left * flat_rms_m(result.data, fit.residual);
    if (left_m > numerics.max_step_change * noise_m && lengthen_steps(result, left_m, log))
        forget_paths(fit.predictions);  // they belong to shorter steps
    if (any_longer(result.step_factors))
        result.notes.push_back("steps of " + steps_in_words(result.setup) + ", whose error is taken off");
    result.fit = judged(result.data, std::move(fit), settings);
    return result;
}

}  // namespace myo::diagnosis
