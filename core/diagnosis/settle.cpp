#include "diagnosis/settle.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/alike_values.hpp"
#include "diagnosis/judge.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

/// The numerical error is found anew where taking it off moves the predictions by more than this share of what is left,
/// and at most so often.
constexpr double settled_share = 0.3;
constexpr int most_rounds = 3;
/// It is not taken over where the fit then leaves so many times the squares.
constexpr double gone_astray = 1.2;
/// An error above this rms is not taken off by its shift alone, and one below the next is; in units of the noise, or of
/// what the fit leaves where that is more.
constexpr double worth_matching = 1.0, well_matched = 0.2;
/// How often numbers are moved so that motions are alike, while each time leaves less than this share of the error.
constexpr int most_matching_steps = 6;
constexpr double little_gained = 0.9;

/// Gives the cells the modulus with which they move like finer ones, and a fit one with which they move as before.
void match_stiffness(DiagnosisWork& work, JointFit& declared, NumericalError& numerics) {
    if (!work.stage("numerical error", 3 * work.fit_count(),
                    [&] { return work.errors.match(declared.values, work.result.data, numerics, work.progress); }))
        return;
    work.result.modulus_factor = work.setup.modulus_factor = work.serial.modulus_factor = numerics.stiffening.factor();
    for (const prediction::ModelParameter& p : declared.parameters)
        if (p.kind == prediction::ModelParameter::Kind::youngs_modulus)
            prediction::set_value(p,
                                  std::clamp(declared.values.youngs_modulus_Pa / work.setup.modulus_factor,
                                             p.parameter.lower, p.parameter.upper),
                                  declared.values);
}

/// The error of a fit where its own numbers make up for most of it in the other runs. None where that is not needed, or
/// cannot be.
std::optional<NumericalError> matched_error(DiagnosisWork& work, const JointFit& fit, const NumericalError& plain,
                                            const std::string& stage) {
    const FitData& data = work.result.data;
    const double unit_m = std::max(work.result.noise_m, flat_rms_m(data, fit.residual));
    if (!(shift_rms_m(plain.shift) > worth_matching * unit_m)) return {};
    const JointFit fresh = work.fit(stage, fit.values,
                                    Effort{1});  // with derivatives there: those of a search are secants
    if (!fresh.usable()) return {};
    std::optional<NumericalError> best;
    for (int step = 0; step < most_matching_steps; ++step) {
        const NumericalError& before = best ? *best : plain;
        const AlikeValues alike = more_alike(data, fresh, before);
        NumericalError numerics = work.stage("numerical error", 4 * work.fit_count(), [&] {
            return work.errors.at(fit.values, data.trials, nullptr, work.progress, &alike);
        });
        const double was = shift_rms_m(before.shift), is = shift_rms_m(numerics.shift);
        if (work.progress.cancelled() || !(is < was)) break;
        best = std::move(numerics);
        if (is < well_matched * unit_m || is > little_gained * was) break;
    }
    return best;
}

struct Settled {
    JointFit fit;
    NumericalError numerics;
};

/// A fit of an effect whose error is large, with what its own numbers make up for in these, and the rest taken off.
/// None where that is not needed, or no better. The declared fit's error is that of all candidates: its numbers stay
/// where they are.
std::optional<Settled> settled_alike(DiagnosisWork& work, const JointFit& fit, const NumericalError& plain,
                                     const std::string& stage, const Settling& settling) {
    if (fit.effects.empty()) return {};
    FitData& data = work.result.data;
    std::optional<NumericalError> found = matched_error(work, fit, plain, stage);
    if (!found) return {};
    NumericalError& numerics = *found;
    const AlikeValues alike = *numerics.alike;
    data.shift = numerics.shift;
    const JointFit there = work.fit(stage, fit.values, settling.effort, neighbourhood_of(fit));
    if (!there.usable()) return {};
    numerics.left_rms_m = extrapolation_left_m(data, numerics, there);
    numerics.rest_rms_m = shift_rms_m(numerics.shift);
    numerics.alike = moved_to(there, alike);
    // The shift is found for the fit's numbers; it has to be that of the numbers at the limit, which are those of the
    // body.
    const prediction::ParameterValues limit = at_the_limit(there, alike, numerics.mesh_factor);
    const std::vector<prediction::TrialPrediction> at_limit = fitted_predictions(work.setup, data.trials, limit,
                                                                                 work.progress);
    if (!prediction::all_ok(at_limit)) return {};
    for (std::size_t i = 0; i < data.trials.size(); ++i)
        add_scaled(difference(there.predictions[i], at_limit[i]), 1.0, numerics.shift[data.trials[i]]);
    data.shift = numerics.shift;
    JointFit ended = work.fit(stage, limit, settling.effort);
    if (!ended.usable()) return {};
    return Settled{std::move(ended), std::move(numerics)};
}

}  // namespace

bool settle(DiagnosisWork& work, JudgedFit& judged_fit, const std::string& stage, const Settling& settling) {
    Diagnosis& result = work.result;
    for (int round = 0; round < most_rounds; ++round) {
        const NumericalError* const known = judged_fit.numerics ? &*judged_fit.numerics
                                                                : nullptr;  // the declared fit may be damped far more
        NumericalError numerics = work.stage("numerical error", 3 * work.fit_count(), [&] {
            return work.errors.at(judged_fit.fit.values, result.data.trials, known, work.progress);
        });
        if (work.progress.cancelled()) return false;
        const bool is_first = !result.declared.numerics;  // until then no error was taken off
        if (is_first) match_stiffness(work, judged_fit.fit, numerics);
        const std::optional<Settled> alike = settled_alike(work, judged_fit.fit, numerics, stage, settling);
        if (work.progress.cancelled()) return false;
        result.data.shift = alike ? alike->numerics.shift : numerics.shift;
        JointFit again = alike ? alike->fit
                               : work.fit(stage, judged_fit.fit.values, settling.effort,
                                          neighbourhood_of(judged_fit.fit));
        if (work.progress.cancelled()) return false;
        if (!again.usable() || (!is_first && again.squares() > gone_astray * judged_fit.fit.squares())) break;
        const double left = std::sqrt(again.squares() / static_cast<double>(again.residual.size()));
        const bool settled = alike ||
                             change_between(judged_fit.fit, again) < std::max(settling.change, settled_share * left);
        const double weight = judged_fit.weight, criterion = judged_fit.criterion;
        judged_fit = judged(result.data, std::move(again), result.settings);
        judged_fit.weight = weight;
        judged_fit.criterion = criterion;
        if (alike)
            numerics = alike->numerics;
        else
            numerics.left_rms_m = extrapolation_left_m(result.data, numerics, judged_fit.fit);
        judged_fit.numerics = std::move(numerics);
        if (settled) break;
    }
    if (!judged_fit.numerics) judged_fit.numerics = result.declared.numerics;
    result.data.shift = judged_fit.numerics ? judged_fit.numerics->shift : PredictionShift{};
    return true;
}

void foretell_error(DiagnosisWork& work, JudgedFit& judged_fit) {
    if (!judged_fit.numerics || judged_fit.numerics->shift.size() != work.setup.trials.size()) return;
    std::vector<std::size_t> others;
    for (const std::size_t t : work.all_trials())
        if (judged_fit.numerics->shift[t].empty()) others.push_back(t);
    if (others.empty() || work.progress.cancelled()) return;
    const int runs = 3 * static_cast<int>(others.size());
    const AlikeValues* const alike = judged_fit.numerics->alike ? &*judged_fit.numerics->alike : nullptr;
    complete(*judged_fit.numerics, work.stage("numerical error", runs, [&] {
        return work.errors.at(judged_fit.fit.values, others, nullptr, work.progress, alike);
    }));
}

}  // namespace myo::diagnosis
