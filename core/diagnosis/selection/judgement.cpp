#include "diagnosis/selection/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace myo::diagnosis {
namespace {

/// Possible numerical error that remains after its removal [noise levels], limited by the policy.
double numerical_doubt(const FitData& data, const NumericalError& numerics, const JudgementPolicy& policy) {
    return std::min(policy.max_allowed, numerics.left_rms_m / mean_noise_m(data));
}

/// Systematic residual that repeated trials leave between each other [noise levels]; 0: none was repeated.
double unrepeatable(const FitData& data) {
    const double noise_m = mean_noise_m(data);
    // Variances add: floor^2 = noise^2 + unrepeatable^2.
    return data.floor_m > noise_m ? std::sqrt(std::pow(data.floor_m / noise_m, 2) - 1.0) : 0.0;
}

/// Mean square on held-out data beyond that of noise alone [noise squares].
double held_out_excess(double rms) { return std::max(0.0, rms * rms - 1.0); }

/// Whether effects predict data they were not fitted to: other trials, or other blocks of time if a single trial
/// determines some of their numbers.
bool predicts_held_out(const JudgedFit& fit, const JudgedFit& before, const JudgementPolicy& policy) {
    const auto rms = fit.single_trial_directions > before.single_trial_directions ? &JudgedFit::held_out_in_time_rms
                                                                                  : &JudgedFit::held_out_rms;
    return held_out_excess(fit.*rms) <=
           std::max(policy.chance_held_out, policy.max_held_out * held_out_excess(before.*rms));
}

/// Whether a fitted value is at a bound, up to rounding (JudgementPolicy::at_bound).
bool at_bound(const prediction::ModelParameter& p, const prediction::ParameterValues& values,
              const JudgementPolicy& policy) {
    const double value = prediction::value_of(p, values), little = policy.at_bound * std::abs(value);
    return value <= p.parameter.lower + little || value >= p.parameter.upper - little;
}

/// Lower confidence limit of the systematic residual [noise levels].
double surely_left(const statistics::SystematicRms& systematic, const JudgementPolicy& policy) {
    return std::isfinite(systematic.deviation) ? systematic.rms - policy.chance_deviations * systematic.deviation
                                               : systematic.rms;
}

/// Systematic residual that a fit may leave [noise levels].
/// @param numerics  error of the fit
/// @param left      systematic residual of the fit [noise levels]
/// @param excused   the remainder may be due to the form of the effect or to the mesh
double tolerated(const NumericalError& numerics, const Baseline& baseline, double left, bool excused) {
    const JudgementPolicy& policy = baseline.policy().judgement;
    const double doubt = numerical_doubt(baseline.data, numerics, policy);
    if (!excused) return std::max(policy.min_systematic, doubt);
    const double was = baseline.declared.tests.systematic.rms;
    // A fit that leaves little may have failed at the mesh alone: then a share of the whole mesh error is admitted.
    const double of_whole_mesh = left <= policy.little_left * was
                                     ? std::min(policy.most_of_mesh, policy.share_of_mesh * numerics.mesh_rms_m /
                                                                         mean_noise_m(baseline.data))
                                     : 0.0;
    return std::max({policy.min_systematic, policy.mesh_error_factor * doubt, policy.share_of_form * was, of_whole_mesh,
                     unrepeatable(baseline.data)});
}

/// Whether the effect is declared for one trial, by its parameter `trial`.
bool acts_in_one_trial(const effect::EffectDeclaration& effect) { return effect::has(effect.parameters, "trial"); }

}  // namespace

double numerical_allowance(const FitData& data, const NumericalError& numerics, const JudgementPolicy& policy) {
    const double doubt = numerical_doubt(data, numerics, policy);
    return std::max({policy.min_systematic, doubt, std::min(policy.max_rough, policy.rough_extrapolation * doubt)});
}

bool modulus_at_bound(const JointFit& fit, const JudgementPolicy& policy) {
    return std::any_of(fit.parameters.begin(), fit.parameters.end(), [&](const prediction::ModelParameter& p) {
        return p.kind == prediction::ModelParameter::Kind::youngs_modulus && at_bound(p, fit.values, policy);
    });
}

bool effect_at_bound(const JointFit& fit, const JudgementPolicy& policy) {
    return std::any_of(fit.parameters.begin(), fit.parameters.end(), [&](const prediction::ModelParameter& p) {
        return p.kind == prediction::ModelParameter::Kind::effect && p.component < 0 && at_bound(p, fit.values, policy);
    });
}

bool differs_from_zero(const JointFit& fit, const JudgementPolicy& policy) {
    if (fit.report.deviations.size() != static_cast<Eigen::Index>(fit.parameters.size())) return true;
    // Tried effects follow those of the experiment.
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
        // The first parameter of an effect is its amount; places and directions need not differ from zero.
        if (amount.name != p.of_effect) continue;
        const double deviations = std::abs(prediction::value_of(p, fit.values)) /
                                  fit.report.deviations(static_cast<Eigen::Index>(i));
        if (deviations > amount.deviations) amount.deviations = deviations;  // false for NaN
    }
    return std::all_of(amounts.begin(), amounts.end(),
                       [&](const auto& amount) { return amount.second.deviations >= policy.significant_deviations; });
}

bool may_explain(const JudgedFit& fit, const Baseline& baseline) {
    const JudgementPolicy& policy = baseline.policy().judgement;
    return fit.usable() && !modulus_at_bound(fit.fit, policy) && differs_from_zero(fit.fit, policy) &&
           predicts_held_out(fit, baseline.declared, policy);
}

bool needs_explanation(const Baseline& baseline) {
    const JudgedFit& declared = baseline.declared;
    return declared.tests.significant() && !declared.drifts() &&
           declared.tests.systematic.rms >
               numerical_allowance(baseline.data, baseline.numerics, baseline.policy().judgement);
}

bool is_faint(const Baseline& baseline) {
    const JudgementPolicy& policy = baseline.policy().judgement;
    return baseline.declared.tests.systematic.rms <=
           std::max(policy.faint, std::min(policy.max_faint, policy.faint_share_of_mesh * baseline.numerics.mesh_rms_m /
                                                                 mean_noise_m(baseline.data)));
}

bool explains(const JudgedFit& fit, const Baseline& baseline, Leniency leniency) {
    if (!may_explain(fit, baseline)) return false;
    const JudgementPolicy& policy = baseline.policy().judgement;
    const bool tolerant = leniency == Leniency::tolerant;
    const double was = baseline.declared.tests.systematic.rms;
    const double left = tolerant ? surely_left(fit.tests.systematic, policy) : fit.tests.systematic.rms;
    // First condition: the effect removes enough. Second, below: what remains has a reason.
    if (left > (is_faint(baseline) ? policy.most_of_faint : policy.most_of_residual) * was) return false;
    // An effect at its bound would have grown further: its remainder is due neither to its form nor to the mesh.
    const bool excused = tolerant && !effect_at_bound(fit.fit, policy);
    return !fit.tests.significant() || fit.drifts() ||
           left <= tolerated(fit.numerics ? *fit.numerics : baseline.numerics, baseline, left, excused);
}

bool is_untested(const JudgedFit& set, const JudgedFit& declared) {
    return set.single_trial_directions > declared.single_trial_directions &&
           std::none_of(set.fit.effects.begin(), set.fit.effects.end(), acts_in_one_trial);
}

}  // namespace myo::diagnosis
