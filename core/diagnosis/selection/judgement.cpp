#include "diagnosis/selection/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "diagnosis/diagnosis_policy.hpp"
#include "statistics/autocorrelation.hpp"
#include "statistics/evidence.hpp"
#include "statistics/linear_cross_validation.hpp"

namespace myo::diagnosis {
namespace {

std::vector<JudgedFit*> single_fits(Diagnosis& d) {
    std::vector<JudgedFit*> fits{&d.declared};
    for (Candidate& candidate : d.candidates)
        if (candidate.judged) fits.push_back(&*candidate.judged);
    return fits;
}

double mean_noise_m(const FitData& data) {
    return std::sqrt(data.noise_m.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, data.noise_m.size())));
}

/// Possible numerical error that remains after its removal [noise levels], limited by the policy.
double numerical_doubt(const FitData& data, const NumericalError& numerics, const JudgementPolicy& policy) {
    return std::min(policy.most_allowed, numerics.left_rms_m / mean_noise_m(data));
}

/// Mean square on held-out data beyond that of noise alone [noise squares].
double held_out_excess(double rms) { return std::max(0.0, rms * rms - 1.0); }

/// Whether effects predict data they were not fitted to: other trials, or other blocks of time if a single trial
/// determines some of their numbers.
bool predicts_held_out(const JudgedFit& fit, const JudgedFit& before, const JudgementPolicy& policy) {
    const auto rms = fit.single_trial_directions > before.single_trial_directions ? &JudgedFit::held_out_in_time_rms
                                                                                  : &JudgedFit::held_out_rms;
    return held_out_excess(fit.*rms) <=
           std::max(policy.chance_held_out, policy.most_held_out * held_out_excess(before.*rms));
}

bool at_bound(const prediction::ModelParameter& p, const prediction::ParameterValues& values) {
    const double value = prediction::value_of(p, values), little = diagnosis_policy.numerics.at_bound * std::abs(value);
    return value <= p.parameter.lower + little || value >= p.parameter.upper - little;
}

/// Lower confidence limit of the systematic residual [noise levels].
double surely_left(const statistics::SystematicRms& systematic, const JudgementPolicy& policy) {
    return std::isfinite(systematic.deviation) ? systematic.rms - policy.chance_deviations * systematic.deviation
                                               : systematic.rms;
}

}  // namespace

JudgedFit judged(const FitData& data, JointFit fit, const DiagnoseSettings& settings) {
    const JudgementPolicy& policy = settings.policy.judgement;
    JudgedFit result;
    if (fit.usable()) {
        statistics::ResidualTestOptions options;
        options.alpha = settings.alpha;
        result.rms_m = flat_rms_m(data, fit.residual);
        result.tests = statistics::test_residuals(fit.residual, data.layout, static_cast<int>(fit.parameters.size()),
                                                  options);
        const double systematic = result.tests.systematic.rms;
        if (result.tests.significant() && systematic > policy.least_systematic && systematic < policy.most_drift)
            result.independence = statistics::independence_test(fit.residual, data.layout);
        statistics::FoldOptions folds;
        folds.guard_s = policy.guard_s;
        const statistics::LinearCrossValidation of_trials = statistics::linear_cross_validation(
            fit.residual, fit.jacobian, statistics::make_folds(data.layout, folds));
        result.held_out_rms = std::sqrt(of_trials.mean_square());
        result.single_trial_directions = of_trials.undetermined();
        result.held_out_in_time_rms = std::sqrt(
            statistics::linear_cross_validation(fit.residual, fit.jacobian, statistics::time_folds(data.layout, folds))
                .mean_square());
    }
    result.fit = std::move(fit);
    return result;
}

void weigh(const FitData& data, const std::vector<JudgedFit*>& fits, const JudgementPolicy& policy) {
    const JudgedFit* best = nullptr;
    for (const JudgedFit* fit : fits)
        if (fit->usable() && (!best || fit->fit.squares() < best->fit.squares())) best = fit;
    if (!best) return;
    const auto samples = static_cast<double>(data.layout.size());
    const double effective = statistics::effective_samples(best->fit.residual, data.layout);
    const auto compare = [&](double JudgedFit::*held_out) {
        for (JudgedFit* fit : fits) {
            fit->criterion = std::numeric_limits<double>::infinity();
            if (fit->usable())
                fit->criterion = 0.5 *
                                     (statistics::information_criterion(fit->fit.squares(), samples, effective,
                                                                        static_cast<int>(fit->fit.parameters.size())) +
                                      statistics::information_criterion(samples * std::pow(fit->*held_out, 2), samples,
                                                                        effective, 0)) +
                                 (effect_at_bound(fit->fit)
                                      ? 2.0 * policy.temperature * std::log(policy.odds_against_bounds)
                                      : 0.0);
        }
    };
    const auto order = [](const JudgedFit* a, const JudgedFit* b) { return a->criterion < b->criterion; };
    compare(&JudgedFit::held_out_rms);
    // Numbers that a single trial determines are not tested by holding out that trial. If the best fit has more of them
    // than another, fits are compared by blocks of time.
    int least_told = std::numeric_limits<int>::max();
    for (const JudgedFit* fit : fits)
        if (fit->usable()) least_told = std::min(least_told, fit->single_trial_directions);
    if ((*std::min_element(fits.begin(), fits.end(), order))->single_trial_directions > least_told)
        compare(&JudgedFit::held_out_in_time_rms);
    std::vector<double> criteria;
    for (const JudgedFit* fit : fits) criteria.push_back(fit->criterion);
    const std::vector<double> weights = statistics::evidence_weights(criteria, policy.temperature);
    for (std::size_t i = 0; i < fits.size(); ++i) fits[i]->weight = weights[i];
}

double weight_among(const JudgedFit& fit, const std::vector<const JudgedFit*>& others, const JudgementPolicy& policy) {
    std::vector<double> criteria{fit.criterion};
    for (const JudgedFit* other : others) criteria.push_back(other->criterion);
    return statistics::evidence_weights(criteria, policy.temperature).front();
}

void order_candidates(Diagnosis& d) {
    weigh(d.data, single_fits(d), d.settings.policy.judgement);
    const auto rank = [&](const Candidate& c) {
        return !c.judged ? 2 : explains(*c.judged, d.declared, d.data, d.numerics, d.settings.policy.judgement) ? 0 : 1;
    };
    std::stable_sort(d.candidates.begin(), d.candidates.end(), [&](const Candidate& a, const Candidate& b) {
        if (rank(a) != rank(b)) return rank(a) < rank(b);
        if (a.judged) return a.judged->criterion < b.judged->criterion;
        return a.score.share() > b.score.share();
    });
}

void order_pairs(Diagnosis& d) {
    std::vector<JudgedFit*> all = single_fits(d);
    for (JudgedFit& pair : d.pairs) all.push_back(&pair);
    weigh(d.data, all, d.settings.policy.judgement);
    std::stable_sort(d.pairs.begin(), d.pairs.end(),
                     [](const JudgedFit& a, const JudgedFit& b) { return a.criterion < b.criterion; });
}

double numerical_allowance(const FitData& data, const NumericalError& numerics, const JudgementPolicy& policy) {
    const double doubt = numerical_doubt(data, numerics, policy);
    return std::max({policy.least_systematic, doubt, std::min(policy.most_rough, policy.rough_extrapolation * doubt)});
}

bool modulus_at_bound(const JointFit& fit) {
    return std::any_of(fit.parameters.begin(), fit.parameters.end(), [&](const prediction::ModelParameter& p) {
        return p.kind == prediction::ModelParameter::Kind::youngs_modulus && at_bound(p, fit.values);
    });
}

bool effect_at_bound(const JointFit& fit) {
    return std::any_of(fit.parameters.begin(), fit.parameters.end(), [&](const prediction::ModelParameter& p) {
        return p.kind == prediction::ModelParameter::Kind::effect && p.component < 0 && at_bound(p, fit.values);
    });
}

bool differs_from_zero(const JointFit& fit, const JudgementPolicy& policy) {
    if (fit.report.deviations.size() != static_cast<Eigen::Index>(fit.parameters.size())) return true;
    const std::size_t first_tried = fit.values.effects.size() - std::min(fit.values.effects.size(), fit.effects.size());
    struct Amount {
        std::string name;
        double deviations = 0.0;  // vector: of its largest component
    };
    std::map<std::size_t, Amount> amounts;
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        const prediction::ModelParameter& p = fit.parameters[i];
        if (p.kind != prediction::ModelParameter::Kind::effect || p.index < first_tried) continue;
        Amount& amount = amounts.try_emplace(p.index, Amount{p.of_effect}).first->second;
        if (amount.name != p.of_effect) continue;
        const double deviations = std::abs(prediction::value_of(p, fit.values)) /
                                  fit.report.deviations(static_cast<Eigen::Index>(i));
        if (deviations > amount.deviations) amount.deviations = deviations;  // false for NaN
    }
    return std::all_of(amounts.begin(), amounts.end(),
                       [&](const auto& amount) { return amount.second.deviations >= policy.significant_deviations; });
}

bool may_explain(const JudgedFit& fit, const JudgedFit& before, const JudgementPolicy& policy) {
    return fit.usable() && !modulus_at_bound(fit.fit) && differs_from_zero(fit.fit, policy) &&
           predicts_held_out(fit, before, policy);
}

bool needs_explanation(const JudgedFit& fit, const FitData& data, const NumericalError& numerics,
                       const JudgementPolicy& policy) {
    return fit.tests.significant() && !fit.drifts() &&
           fit.tests.systematic.rms > numerical_allowance(data, numerics, policy);
}

bool is_faint(const JudgedFit& fit, const FitData& data, const NumericalError& numerics,
              const JudgementPolicy& policy) {
    return fit.tests.systematic.rms <=
           std::max(policy.faint,
                    std::min(policy.most_faint, policy.faint_share_of_mesh * numerics.mesh_rms_m / mean_noise_m(data)));
}

bool explains(const JudgedFit& fit, const JudgedFit& before, const FitData& data, const NumericalError& numerics,
              const JudgementPolicy& policy, Leniency leniency) {
    if (!may_explain(fit, before, policy)) return false;
    const NumericalError& own = fit.numerics ? *fit.numerics : numerics;
    const double doubt = numerical_doubt(data, own, policy), was = before.tests.systematic.rms;
    const double left = leniency == Leniency::generous ? surely_left(fit.tests.systematic, policy)
                                                       : fit.tests.systematic.rms;
    // An effect at its bound would have grown further: its remainder is due neither to its form nor to the mesh.
    const bool excused = leniency == Leniency::generous && !effect_at_bound(fit.fit);
    const double of_mesh = doubt * (excused ? policy.generous : 1.0),
                 of_form = excused ? policy.share_of_form * was : 0.0;
    const double of_whole_mesh = excused && left <= policy.little_left * was
                                     ? std::min(policy.most_of_mesh,
                                                policy.share_of_mesh * own.mesh_rms_m / mean_noise_m(data))
                                     : 0.0;
    if (left > (is_faint(before, data, numerics, policy) ? policy.most_of_faint : policy.most_of_residual) * was)
        return false;
    return !fit.tests.significant() || fit.drifts() ||
           left <= std::max({policy.least_systematic, of_mesh, of_form, of_whole_mesh});
}

bool explained(const Diagnosis& diagnosis, Leniency leniency) {
    const std::vector<Candidate>& ranked = diagnosis.candidates;
    return !ranked.empty() && ranked.front().judged &&
           explains(*ranked.front().judged, diagnosis.declared, diagnosis.data, diagnosis.numerics,
                    diagnosis.settings.policy.judgement, leniency);
}

double left_by(const Diagnosis& diagnosis, const std::string& effect) {
    for (const Candidate& candidate : diagnosis.candidates)
        if (candidate.score.id == effect && candidate.judged) return candidate.judged->fit.squares();
    return std::numeric_limits<double>::infinity();
}

double least_left(const Diagnosis& diagnosis) {
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : diagnosis.candidates)
        least = std::min(least, left_by(diagnosis, candidate.score.id));
    return least;
}

}  // namespace myo::diagnosis
