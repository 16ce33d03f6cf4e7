#include "diagnosis/discretisation/correct_discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/discretisation/discretisation_match.hpp"
#include "diagnosis/discretisation/effective_modulus.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "prediction/predict_trials.hpp"
#include "prediction/run_trials.hpp"

namespace myo::diagnosis {
namespace {

constexpr const char* error_phase = "numerical error";

/// Refit with an error removed.
struct Refit {
    JointFit fit;
    NumericalError numerics;
    bool matched = false;  // parameters were matched between the coarse and the refined runs
};

/// Number of trials whose error is computed.
int fit_count(const CorrectionInput& in) { return static_cast<int>(in.data.trials.size()); }

/// The data with another correction of the predictions.
FitData with_shift(FitData data, const PredictionShift& shift) {
    data.shift = shift;
    return data;
}

/// Fit of all parameters from `start`, logged under the phase of the input.
JointFit refit(const CorrectionInput& in, const FitData& data, const prediction::ParameterValues& start,
               const Effort& effort, const WarmStart& warm, FitStore& store, PhaseLog& log) {
    return logged_fit(in.phase, {in.setup, data, start, in.settings.policy, EffectFreedom::all, effort, warm}, store,
                      log);
}

/// Scales the fitted moduli such that the motion stays the same with another modulus factor of the cells.
/// Cells of factor times the modulus move with E / factor as they did with E.
void scale_modulus(JointFit& fit, double factor) {
    for (const prediction::ModelParameter& p : fit.parameters)
        if (p.kind == prediction::ModelParameter::Kind::youngs_modulus ||
            p.kind == prediction::ModelParameter::Kind::part_modulus)
            prediction::set_value(
                p, std::clamp(prediction::value_of(p, fit.values) / factor, p.parameter.lower, p.parameter.upper),
                fit.values);
}

/// Numerical error of a fit after its own parameters have been matched between the runs. Empty if the error is small,
/// or if matching does not reduce it.
std::optional<NumericalError> matched_error(const CorrectionInput& in, const JointFit& fit, const FitData& data,
                                            const NumericalError& plain, FitStore& store, PhaseLog& log) {
    const NumericsPolicy& policy = in.settings.policy.numerics;
    // Errors count in noise levels, but not below what the fit leaves anyway.
    const double unit_m = std::max(mean_noise_m(data), flat_rms_m(data, fit.residual));
    if (!(shift_rms_m(plain.shift) > policy.min_matched_error * unit_m)) return {};
    // New derivatives: those of a search are secant approximations.
    const JointFit fresh = refit(in, data, fit.values, Effort{1}, {}, store, log);
    if (!fresh.usable()) return {};
    std::optional<NumericalError> best;
    for (int step = 0; step < policy.max_matching_steps; ++step) {
        const NumericalError& before = best ? *best : plain;
        const MatchedValues matched = match_discretisation(data, fresh, before, policy);
        NumericalError numerics = log.timed(error_phase, 4 * fit_count(in), [&] {
            return error_at({in.setup, in.refinement, fit.values, data.trials, nullptr, &matched}, policy,
                            log.progress());
        });
        // Newton's iteration converges fast or not at all: the best error so far is kept.
        const double was = shift_rms_m(before.shift), is = shift_rms_m(numerics.shift);
        if (log.cancelled() || !(is < was)) break;
        best = std::move(numerics);
        if (is < policy.matched_error * unit_m || is > policy.min_matching_gain * was) break;
    }
    return best;
}

/// Refit of effects with a large numerical error: the fit's parameters are matched between the coarse and the refined
/// runs, and the remaining error is removed. Empty if that is not needed or not possible.
std::optional<Refit> matched_refit(const CorrectionInput& in, const JointFit& fit, FitData data,
                                   const NumericalError& plain, FitStore& store, PhaseLog& log) {
    if (fit.effects.empty()) return {};
    const NumericsPolicy& policy = in.settings.policy.numerics;
    std::optional<NumericalError> found = matched_error(in, fit, data, plain, store, log);
    if (!found) return {};
    NumericalError& numerics = *found;
    const MatchedValues matched = *numerics.matched;
    // First refit: with the error that remains after matching, at the matched values.
    data.shift = numerics.shift;
    const JointFit there = refit(in, data, fit.values, in.correction.effort, warm_start_of(fit), store, log);
    if (!there.usable()) return {};
    numerics.left_rms_m = extrapolation_left_m(data, numerics, there, policy);
    numerics.rest_rms_m = shift_rms_m(numerics.shift);
    numerics.matched = moved_match(there, matched);
    // The shift was found at the fitted values; it must hold at the extrapolated ones, which are those of the body.
    const prediction::ParameterValues limit = extrapolated_values(there, matched, numerics.mesh_factor, policy);
    const std::vector<prediction::TrialPrediction> at_limit = fitted_predictions(in.setup, data.trials, limit,
                                                                                 log.progress());
    if (!prediction::all_ok(at_limit)) return {};
    for (std::size_t i = 0; i < data.trials.size(); ++i)
        add_scaled(difference(there.predictions[i], at_limit[i]), 1.0, numerics.shift[data.trials[i]]);
    // Second refit: from the extrapolated values, with new derivatives.
    JointFit ended = refit(in, with_shift(std::move(data), numerics.shift), limit, in.correction.effort, {}, store,
                           log);
    if (!ended.usable()) return {};
    return Refit{std::move(ended), std::move(numerics), true};
}

/// Refit with the error removed, from the values of a fit.
Refit plain_refit(const CorrectionInput& in, const JointFit& fit, NumericalError numerics, FitStore& store,
                  PhaseLog& log) {
    const FitData data = with_shift(in.data, numerics.shift);
    JointFit again = refit(in, data, fit.values, in.correction.effort, warm_start_of(fit), store, log);
    if (again.usable()) numerics.left_rms_m = extrapolation_left_m(data, numerics, again, in.settings.policy.numerics);
    return {std::move(again), std::move(numerics), false};
}

/// Error at the values of a fit, with equal values in all runs; its step part is reused if negligible.
NumericalError plain_error(const CorrectionInput& in, const JudgedFit& fit, PhaseLog& log) {
    return log.timed(error_phase, 3 * fit_count(in), [&] {
        return error_at(
            {in.setup, in.refinement, fit.fit.values, in.data.trials, fit.numerics ? &*fit.numerics : nullptr},
            in.settings.policy.numerics, log.progress());
    });
}

/// Whether the refit changes predictions so little that its error need not be computed again.
bool is_converged(const CorrectionInput& in, const JointFit& fit, const Refit& again) {
    const double left = std::sqrt(again.fit.squares() / static_cast<double>(again.fit.residual.size()));
    return again.matched || change_between(fit, again.fit) <
                                std::max(in.correction.max_change, in.settings.policy.numerics.converged_share * left);
}

/// The refit, assessed, with the place of the earlier fit among others.
JudgedFit replaced(const CorrectionInput& in, const JudgedFit& before, Refit again) {
    JudgedFit fit = judged(with_shift(in.data, again.numerics.shift), std::move(again.fit), in.settings);
    fit.weight = before.weight;
    fit.criterion = before.criterion;
    fit.numerics = std::move(again.numerics);
    return fit;
}

/// Rounds of error and refit, from the given number of rounds on.
std::optional<JudgedFit> corrected_in_rounds(const CorrectionInput& in, JudgedFit fit, int round, FitStore& store,
                                             PhaseLog& log) {
    const NumericsPolicy& policy = in.settings.policy.numerics;
    for (; round < policy.max_rounds; ++round) {
        NumericalError plain = plain_error(in, fit, log);
        if (log.cancelled()) return {};
        const FitData data = fit.numerics ? with_shift(in.data, fit.numerics->shift) : in.data;
        // Matching applies to fits with effects and large errors only; all others are refitted with the plain error.
        std::optional<Refit> again = matched_refit(in, fit.fit, data, plain, store, log);
        if (log.cancelled()) return {};
        if (!again) again = plain_refit(in, fit.fit, std::move(plain), store, log);
        if (log.cancelled()) return {};
        if (!again->fit.usable() || again->fit.squares() > policy.max_growth * fit.fit.squares()) break;
        const bool converged = is_converged(in, fit.fit, *again);
        fit = replaced(in, fit, std::move(*again));
        if (converged) break;
    }
    return fit;
}

}  // namespace

std::optional<JudgedFit> correct_discretisation(const CorrectionInput& in, JudgedFit fit, FitStore& store,
                                                PhaseLog& log) {
    return corrected_in_rounds(in, std::move(fit), 0, store, log);
}

std::optional<CorrectedDeclaredFit> correct_declared_fit(const CorrectionInput& in, JudgedFit fit, FitStore& store,
                                                         PhaseLog& log) {
    const NumericsPolicy& policy = in.settings.policy.numerics;
    CorrectedDeclaredFit result;
    setup::Setup setup = in.setup;
    // Refers to `setup` and `result.refinement`, which get their values below.
    const CorrectionInput with{setup, in.data, in.settings, result.refinement, in.phase, in.correction};
    NumericalError error = log.timed(error_phase, 3 * fit_count(in), [&] {
        result.refinement = refined(setup, in.settings.refine_mesh, policy, log.progress());
        return error_at({setup, result.refinement, fit.fit.values, in.data.trials}, policy, log.progress());
    });
    if (log.cancelled()) return {};
    const std::optional<NumericalError> by_modulus = log.timed(error_phase, 3 * fit_count(in), [&] {
        return match_modulus(setup, prediction::with_predicted_levels(setup, fit.fit.values), in.data, error, policy,
                             log.progress());
    });
    // From here on the cells have the effective modulus, and the fitted moduli are converted, so that the motion stays.
    if (by_modulus) {
        result.refinement.unmatched = error = *by_modulus;
        result.modulus_factor = setup.modulus_factor = error.effective_modulus.factor();
        scale_modulus(fit.fit, setup.modulus_factor);
    }
    if (log.cancelled()) return {};
    Refit again = plain_refit(with, fit.fit, std::move(error), store, log);
    if (log.cancelled()) return {};
    if (again.fit.usable()) {
        const bool converged = is_converged(with, fit.fit, again);
        fit = replaced(with, fit, std::move(again));
        // One round was made above, hence from 1 on.
        std::optional<JudgedFit> corrected = converged ? std::move(fit)
                                                       : corrected_in_rounds(with, std::move(fit), 1, store, log);
        if (!corrected) return {};
        fit = std::move(*corrected);
    }
    result.fit = std::move(fit);
    // A zero error: later phases expect one.
    if (!result.fit.numerics) result.fit.numerics.emplace();
    return result;
}

NumericalError with_error_of_other_trials(const DiagnosisContext& context, const JudgedFit& fit, PhaseLog& log) {
    const NumericalError& own = *fit.numerics;
    if (own.shift.size() != context.setup.trials.size()) return own;
    std::vector<std::size_t> others;
    for (std::size_t t = 0; t < context.setup.trials.size(); ++t)
        if (own.shift[t].empty()) others.push_back(t);
    if (others.empty() || log.cancelled()) return own;
    const MatchedValues* const matched = own.matched ? &*own.matched : nullptr;
    return completed(own, log.timed(error_phase, 3 * static_cast<int>(others.size()), [&] {
        return error_at({context.setup, context.refinement, fit.fit.values, others, nullptr, matched},
                        context.policy().numerics, log.progress());
    }));
}

}  // namespace myo::diagnosis
