#include "diagnosis/discretisation/correct_discretisation.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/discretisation/discretisation_match.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

/// Sets the effective modulus, with which the cells move like finer ones, and scales the fitted modulus such that the
/// motion stays the same.
void match_modulus(DiagnosisWork& work, JointFit& declared, NumericalError& numerics) {
    if (!work.stage("numerical error", 3 * work.fit_count(),
                    [&] { return work.errors.match(declared.values, work.result.data, numerics, work.progress); }))
        return;
    work.result.modulus_factor = work.setup.modulus_factor = work.serial.modulus_factor = numerics.effective_modulus
                                                                                              .factor();
    for (const prediction::ModelParameter& p : declared.parameters)
        if (p.kind == prediction::ModelParameter::Kind::youngs_modulus)
            prediction::set_value(p,
                                  std::clamp(declared.values.youngs_modulus_Pa / work.setup.modulus_factor,
                                             p.parameter.lower, p.parameter.upper),
                                  declared.values);
}

/// Numerical error of a fit after its own parameters have been matched between the runs. Empty if the error is small,
/// or if matching does not reduce it.
std::optional<NumericalError> matched_error(DiagnosisWork& work, const JointFit& fit, const NumericalError& plain,
                                            const std::string& stage) {
    const FitData& data = work.result.data;
    const double unit_m = std::max(work.result.noise_m, flat_rms_m(data, fit.residual));
    if (!(shift_rms_m(plain.shift) > diagnosis_policy.numerics.least_matched_error * unit_m)) return {};
    const JointFit fresh = work.fit(stage, fit.values,
                                    Effort{1});  // new derivatives: those of a search are secant approximations
    if (!fresh.usable()) return {};
    std::optional<NumericalError> best;
    for (int step = 0; step < diagnosis_policy.numerics.most_matching_steps; ++step) {
        const NumericalError& before = best ? *best : plain;
        const MatchedValues matched = match_discretisation(data, fresh, before);
        NumericalError numerics = work.stage("numerical error", 4 * work.fit_count(), [&] {
            return work.errors.at(fit.values, data.trials, nullptr, work.progress, &matched);
        });
        const double was = shift_rms_m(before.shift), is = shift_rms_m(numerics.shift);
        if (work.progress.cancelled() || !(is < was)) break;
        best = std::move(numerics);
        if (is < diagnosis_policy.numerics.matched_error * unit_m ||
            is > diagnosis_policy.numerics.least_matching_gain * was)
            break;
    }
    return best;
}

struct CorrectedFit {
    JointFit fit;
    NumericalError numerics;
};

/// Refit of effects with a large numerical error: the fit's parameters are matched between the coarse and the refined
/// runs, and the remaining error is removed. Empty if that is not needed or not possible. The declared fit is not
/// matched: its error serves all candidates, so its parameters must stay.
std::optional<CorrectedFit> corrected_by_matching(DiagnosisWork& work, const JointFit& fit, const NumericalError& plain,
                                                  const std::string& stage, const ErrorCorrection& correction) {
    if (fit.effects.empty()) return {};
    FitData& data = work.result.data;
    std::optional<NumericalError> found = matched_error(work, fit, plain, stage);
    if (!found) return {};
    NumericalError& numerics = *found;
    const MatchedValues matched = *numerics.matched;
    data.shift = numerics.shift;
    const JointFit there = work.fit(stage, fit.values, correction.effort, neighbourhood_of(fit));
    if (!there.usable()) return {};
    numerics.left_rms_m = extrapolation_left_m(data, numerics, there);
    numerics.rest_rms_m = shift_rms_m(numerics.shift);
    numerics.matched = moved_match(there, matched);
    // The shift was found at the fitted values; it must hold at the extrapolated ones, which are those of the body.
    const prediction::ParameterValues limit = extrapolated_values(there, matched, numerics.mesh_factor);
    const std::vector<prediction::TrialPrediction> at_limit = fitted_predictions(work.setup, data.trials, limit,
                                                                                 work.progress);
    if (!prediction::all_ok(at_limit)) return {};
    for (std::size_t i = 0; i < data.trials.size(); ++i)
        add_scaled(difference(there.predictions[i], at_limit[i]), 1.0, numerics.shift[data.trials[i]]);
    data.shift = numerics.shift;
    JointFit ended = work.fit(stage, limit, correction.effort);
    if (!ended.usable()) return {};
    return CorrectedFit{std::move(ended), std::move(numerics)};
}

}  // namespace

bool correct_discretisation(DiagnosisWork& work, JudgedFit& judged_fit, const std::string& stage,
                            const ErrorCorrection& correction) {
    Diagnosis& result = work.result;
    for (int round = 0; round < diagnosis_policy.numerics.most_rounds; ++round) {
        const NumericalError* const known = judged_fit.numerics ? &*judged_fit.numerics
                                                                : nullptr;  // declared fit: damping may be far larger
        NumericalError numerics = work.stage("numerical error", 3 * work.fit_count(), [&] {
            return work.errors.at(judged_fit.fit.values, result.data.trials, known, work.progress);
        });
        if (work.progress.cancelled()) return false;
        const bool is_first = !result.declared.numerics;  // no error has been removed so far
        if (is_first) match_modulus(work, judged_fit.fit, numerics);
        const std::optional<CorrectedFit> matched = corrected_by_matching(work, judged_fit.fit, numerics, stage,
                                                                          correction);
        if (work.progress.cancelled()) return false;
        result.data.shift = matched ? matched->numerics.shift : numerics.shift;
        JointFit again = matched ? matched->fit
                                 : work.fit(stage, judged_fit.fit.values, correction.effort,
                                            neighbourhood_of(judged_fit.fit));
        if (work.progress.cancelled()) return false;
        if (!again.usable() ||
            (!is_first && again.squares() > diagnosis_policy.numerics.most_growth * judged_fit.fit.squares()))
            break;
        const double left = std::sqrt(again.squares() / static_cast<double>(again.residual.size()));
        const bool corrected = matched ||
                               change_between(judged_fit.fit, again) <
                                   std::max(correction.most_change, diagnosis_policy.numerics.converged_share * left);
        const double weight = judged_fit.weight, criterion = judged_fit.criterion;
        judged_fit = judged(result.data, std::move(again), result.settings);
        judged_fit.weight = weight;
        judged_fit.criterion = criterion;
        if (matched)
            numerics = matched->numerics;
        else
            numerics.left_rms_m = extrapolation_left_m(result.data, numerics, judged_fit.fit);
        judged_fit.numerics = std::move(numerics);
        if (corrected) break;
    }
    if (!judged_fit.numerics) judged_fit.numerics = result.declared.numerics;
    result.data.shift = judged_fit.numerics ? judged_fit.numerics->shift : PredictionShift{};
    return true;
}

void add_error_of_other_trials(DiagnosisWork& work, JudgedFit& judged_fit) {
    if (!judged_fit.numerics || judged_fit.numerics->shift.size() != work.setup.trials.size()) return;
    std::vector<std::size_t> others;
    for (const std::size_t t : work.all_trials())
        if (judged_fit.numerics->shift[t].empty()) others.push_back(t);
    if (others.empty() || work.progress.cancelled()) return;
    const int runs = 3 * static_cast<int>(others.size());
    const MatchedValues* const matched = judged_fit.numerics->matched ? &*judged_fit.numerics->matched : nullptr;
    complete(*judged_fit.numerics, work.stage("numerical error", runs, [&] {
        return work.errors.at(judged_fit.fit.values, others, nullptr, work.progress, matched);
    }));
}

}  // namespace myo::diagnosis
