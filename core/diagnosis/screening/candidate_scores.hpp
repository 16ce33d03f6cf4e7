#pragma once

#include "diagnosis/screening/effect_scores.hpp"

namespace myo::diagnosis {

/// score_effects() by runs of twice the step, where that changes the predictions by less than a share of the residual;
/// otherwise by the setup's own steps.
std::vector<EffectScore> score_with_longer_steps(const setup::Setup& setup, const FitData& data, const JointFit& base,
                                                 const EffectFilter& allowed, ProbeSize size, const Progress& progress);

/// The score that would leave least; an empty one where there is none.
EffectScore best_score(const std::vector<EffectScore>& scores);

/// Numbers of the best probes of the best effects, at most `count`, in falling order of what they explain.
std::vector<std::size_t> best_probes(const std::vector<EffectScore>& scores, int count);

/// Numbers of the next best probes, at other places or along other axes, of the wanted effects: a fit that starts at
/// the best one may end where it is best nearby only. At most two of an effect that promise at least half of what its
/// best does, and six of all, in falling order.
std::vector<std::size_t> other_places(const std::vector<EffectScore>& scores, const EffectFilter& wanted);

}  // namespace myo::diagnosis
