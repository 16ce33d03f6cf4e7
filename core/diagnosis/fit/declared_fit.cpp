#include "diagnosis/fit/declared_fit.hpp"

#include <numeric>
#include <optional>
#include <utility>

#include "base/text.hpp"
#include "diagnosis/discretisation/coarser_cells.hpp"
#include "diagnosis/discretisation/longer_steps.hpp"
#include "diagnosis/discretisation/refinement.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "prediction/predict_trials.hpp"
#include "prediction/runnable_start.hpp"

namespace myo::diagnosis {
namespace {

/// Indices of all trials.
std::vector<std::size_t> all_trials(const setup::Setup& setup) {
    std::vector<std::size_t> all(setup.trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

/// The runs of the fit trials among those of all trials.
std::vector<prediction::TrialPrediction> of_trials(const FitData& data,
                                                   const std::vector<prediction::TrialPrediction>& runs) {
    std::vector<prediction::TrialPrediction> fitted;
    for (const std::size_t t : data.trials) fitted.push_back(runs[t]);
    return fitted;
}

/// Residual of runs of the fit trials [m, rms]; 0 if one failed.
double rms_m(const FitData& data, const std::vector<prediction::TrialPrediction>& runs) {
    return prediction::all_ok(runs) ? flat_rms_m(data, flat_residual(data, runs)) : 0.0;
}

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

/// Runs of all trials with the declared values: they show which trials are repeats, and what these values leave.
std::vector<prediction::TrialPrediction> declared_runs(const setup::Setup& setup,
                                                       const prediction::ParameterValues& declared, PhaseLog& log) {
    const std::vector<std::size_t> all = all_trials(setup);
    return log.timed("declared model", static_cast<int>(all.size()),
                     [&] { return prediction::predict_trials_with(setup, declared, all, log.progress()); });
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

/// Takes coarser cells if no prediction changes by more than max_m [m, rms], of trials that are not fitted, too: their
/// motion may be larger. Only where the mesh error is removed.
/// @param runs  of all trials, with `values` and the cells that result.setup has
void coarsen_cells(DeclaredFit& result, const prediction::ParameterValues& values,
                   const std::vector<prediction::TrialPrediction>& runs, double max_m, const DiagnoseSettings& settings,
                   PhaseLog& log) {
    if (!settings.refine_mesh) return;
    const CoarserCells cells = log.timed("cells", 0, [&] {
        return coarser_cells(result.setup, values, all_trials(result.setup), runs, max_m, settings.policy.numerics,
                             log.progress());
    });
    log.add("cells", 0.0, cells.runs);
    if (!cells.setup) return;
    result.coarser = cells.setup;
    result.cell_change_m = cells.change_m;
    result.setup = *cells.setup;
}

/// Start of the declared fit where the declared values leave much: the values of a fit with coarser cells and longer
/// steps, whose error is a small share of that. Coarsens and lengthens those of `result` as far as this fit's residual
/// allows. Empty where it saves nothing.
std::optional<prediction::ParameterValues> rough_start(DeclaredFit& result, const prediction::ParameterValues& declared,
                                                       const std::vector<prediction::TrialPrediction>& runs,
                                                       const DiagnoseSettings& settings, FitStore& store,
                                                       PhaseLog& log) {
    const NumericsPolicy& policy = settings.policy.numerics;
    const double noise_m = setup::mean_noise(result.setup), left_m = rms_m(result.data, of_trials(result.data, runs));
    const bool by_cells = policy.cell_change_of_left * left_m > policy.max_cell_change * noise_m,
               by_steps = policy.step_change_of_left * left_m > policy.max_step_change * noise_m;
    if (log.cancelled() || !(by_cells || by_steps)) return {};
    DeclaredFit rough = result;
    if (by_cells && !rough.coarser)
        coarsen_cells(rough, declared, runs, policy.cell_change_of_left * left_m, settings, log);
    const bool longer = by_steps && lengthen_steps(rough, policy.step_change_of_left * left_m, log);
    if (log.cancelled() || !(longer || rough.coarser != result.coarser)) return {};
    const JointFit fit = fit_of_declared(rough, declared, settings, store, log);
    if (log.cancelled() || !fit.usable()) return {};
    const double fitted_m = flat_rms_m(rough.data, fit.residual);
    if (rough.coarser != result.coarser && rough.cell_change_m <= policy.cell_change_of_left * fitted_m) {
        result.coarser = rough.coarser;
        result.setup = *rough.coarser;
    }
    if (policy.step_change_of_left * fitted_m > policy.max_step_change * noise_m)
        lengthen_steps(result, policy.step_change_of_left * fitted_m, log);
    return fit.values;
}

}  // namespace

DeclaredFit fit_declared(const setup::Setup& setup, const DiagnoseSettings& settings, FitStore& store, PhaseLog& log) {
    DeclaredFit result{
        .setup = setup,
        .data = fit_data(setup, prediction::trials_with_role(setup, experiment::TrialRole::fit)),
    };
    if (result.data.layout.size() == 0) {
        result.failure = "no sample of a fit trial can be compared";
        return result;
    }
    const NumericsPolicy& numerics = settings.policy.numerics;
    const double noise_m = setup::mean_noise(setup);
    const prediction::ParameterValues declared = prediction::declared_values(result.setup);
    const std::vector<prediction::TrialPrediction> runs = declared_runs(result.setup, declared, log);
    result.repeatability = repeatability(result.setup, runs, settings.policy.repeats);
    result.data.floor_m = result.repeatability.rms_m;
    if (log.cancelled()) return result;
    // Cells and steps first, at the declared values: the time of all later phases depends on their number.
    coarsen_cells(result, declared, runs, numerics.max_cell_change * noise_m, settings, log);
    lengthen_steps(result, numerics.max_step_change * noise_m, log);
    if (log.cancelled()) return result;
    // Most evaluations are made with the cells and steps that the residual allows at that point.
    const auto rough = rough_start(result, declared, runs, settings, store, log);
    if (log.cancelled()) return result;
    JointFit fit = fit_of_declared(result, rough ? *rough : declared, settings, store, log);
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
    if (!rough && left_m > numerics.max_step_change * noise_m && lengthen_steps(result, left_m, log))
        forget_paths(fit.predictions);  // they belong to shorter steps
    if (result.coarser)
        result.notes.push_back("cells of " + format_number(1e3 * result.setup.mesh.resolution_m, 3) +
                               " mm, whose error is taken off");
    if (any_longer(result.step_factors))
        result.notes.push_back("steps of " + steps_in_words(result.setup) + ", whose error is taken off");
    result.fit = judged(result.data, std::move(fit), settings);
    return result;
}

}  // namespace myo::diagnosis
