#include "loop/settle.hpp"

#include <algorithm>
#include <cmath>

#include "loop/judge.hpp"

namespace myo {
namespace {

/// The numerical error is found anew where taking it off moves the predictions by more than this share of what is left, and at most so often.
constexpr double settled_share = 0.3;
constexpr int most_rounds = 3;
/// It is not taken over where the fit then leaves so many times the squares.
constexpr double gone_astray = 1.2;

/// Gives the cells the modulus with which they move like finer ones, and a fit one with which they move as before.
void match_stiffness(DiagnosisWork& work, JointFit& declared, NumericalError& numerics) {
    if (!work.stage("numerical error", 3 * work.fit_count(), [&] { return work.errors.match(declared.values, work.result.data, numerics, work.progress); })) return;
    work.result.modulus_factor = work.study.modulus_factor = work.serial.modulus_factor = numerics.stiffening.factor();
    for (const StudyParameter& p : declared.parameters)
        if (p.kind == StudyParameter::Kind::youngs_modulus)
            set_value(p, std::clamp(declared.values.youngs_modulus_Pa / work.study.modulus_factor, p.parameter.lower, p.parameter.upper), declared.values);
}

}  // namespace

bool settle(DiagnosisWork& work, JudgedFit& judged_fit, const std::string& stage, const Settling& settling) {
    Diagnosis& result = work.result;
    for (int round = 0; round < most_rounds; ++round) {
        const NumericalError* const known = judged_fit.numerics ? &*judged_fit.numerics : nullptr;   // the declared fit may be damped far more
        NumericalError numerics =
            work.stage("numerical error", 3 * work.fit_count(), [&] { return work.errors.at(judged_fit.fit.values, result.data.trials, known, work.progress); });
        if (work.progress.cancelled()) return false;
        const bool is_first = !result.declared.numerics;   // until then no error was taken off
        if (is_first) match_stiffness(work, judged_fit.fit, numerics);
        result.data.shift = numerics.shift;
        JointFit again = work.fit(stage, judged_fit.fit.values, settling.effort, neighbourhood_of(judged_fit.fit));
        if (work.progress.cancelled()) return false;
        if (!again.usable() || (!is_first && again.squares() > gone_astray * judged_fit.fit.squares())) break;
        const double left = std::sqrt(again.squares() / static_cast<double>(again.residual.size()));
        const bool settled = change_between(judged_fit.fit, again) < std::max(settling.change, settled_share * left);
        const double weight = judged_fit.weight, criterion = judged_fit.criterion;
        judged_fit = judged(result.data, std::move(again), result.settings);
        judged_fit.weight = weight;
        judged_fit.criterion = criterion;
        numerics.left_rms_m = extrapolation_left_m(result.data, numerics, judged_fit.fit);
        judged_fit.numerics = std::move(numerics);
        if (settled) break;
    }
    if (!judged_fit.numerics) judged_fit.numerics = result.declared.numerics;
    result.data.shift = judged_fit.numerics ? judged_fit.numerics->shift : PredictionShift{};
    return true;
}

void foretell_error(DiagnosisWork& work, JudgedFit& judged_fit) {
    if (!judged_fit.numerics || judged_fit.numerics->shift.size() != work.study.trials.size()) return;
    std::vector<std::size_t> others;
    for (const std::size_t t : work.all_trials())
        if (judged_fit.numerics->shift[t].empty()) others.push_back(t);
    if (others.empty() || work.progress.cancelled()) return;
    const int runs = 3 * static_cast<int>(others.size());
    complete(*judged_fit.numerics, work.stage("numerical error", runs, [&] { return work.errors.at(judged_fit.fit.values, others, nullptr, work.progress); }));
}

}  // namespace myo
