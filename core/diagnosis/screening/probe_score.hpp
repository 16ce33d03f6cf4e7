#pragma once

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/screening/effect_scores.hpp"
#include "effect/effect.hpp"
#include "statistics/nuisance_space.hpp"

namespace myo::diagnosis {

/// Fit on whose residual probes are scored, with what all scores have in common.
struct ScoreReference {
    const JointFit& fit;
    const statistics::ResidualLayout& layout;
    statistics::NuisanceSpace nuisance;  // of the fit's own parameters
    Eigen::VectorXd outside;             // N: residual outside it
    Eigen::VectorXd lower, upper;        // admissible steps of the fit's own parameters
    double squares = 0.0;                // squared residual after their best step
};
/// Refers to `fit` and `layout`, which must outlive it.
ScoreReference score_reference(const JointFit& fit, const statistics::ResidualLayout& layout);

/// Scores a probe by its response.
///
/// The fit's parameters and the candidate together take the best step within their bounds: a modulus at the limit of
/// its tolerance must not replace the missing effect. The amount is limited to a multiple of the probe that changes the
/// residual by a few times its norm (ScreeningPolicy). Of several columns, those that are hardly observable are damped.
/// @param S  N x columns of the probe: change of the residual by each of them
/// @return   not usable if the response is zero or within the nuisance space, or if its best amount has a sign that the
///           bounds exclude
EffectScore score_probe(const effect::Effect& effect, const effect::EffectProbe& probe, const Eigen::MatrixXd& S,
                        const ScoreReference& reference, const ScreeningPolicy& policy);

}  // namespace myo::diagnosis
