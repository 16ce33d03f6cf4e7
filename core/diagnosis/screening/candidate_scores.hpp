#pragma once

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/screening/effect_scores.hpp"

namespace myo::diagnosis {

/// score_effects() with doubled steps if that changes the predictions by less than a share of the residual; otherwise
/// with the steps of the setup.
/// Scores need responses to a few percent only, and doubled steps halve the time of all probes. Empty if cancelled.
std::vector<EffectScore> score_with_longer_steps(const setup::Setup& setup, const FitData& data, const JointFit& base,
                                                 const EffectFilter& allowed, ProbeSize size,
                                                 const ScreeningPolicy& policy, const Progress& progress);

/// Score that leaves the smallest squared residual; a default one if there is none.
EffectScore best_score(const std::vector<EffectScore>& scores);

/// Indices of the best probe of each of the best effects, at most `count`, by decreasing explained share.
/// Probes that explain less than ScreeningPolicy::min_explained are left out.
std::vector<std::size_t> best_probes(const std::vector<EffectScore>& scores, int count, const ScreeningPolicy& policy);

/// Indices of the next best probes of the wanted effects at other places or along other axes, by decreasing explained
/// share: a fit from the best probe may end in a local minimum. At most two per effect, each with at least half the
/// share of the effect's best probe, and six in total (ScreeningPolicy).
std::vector<std::size_t> other_places(const std::vector<EffectScore>& scores, const EffectFilter& wanted,
                                      const ScreeningPolicy& policy);

}  // namespace myo::diagnosis
