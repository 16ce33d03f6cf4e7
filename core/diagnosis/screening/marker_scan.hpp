#pragma once

#include <vector>

#include "diagnosis/screening/effect_scores.hpp"

namespace myo::diagnosis {

/// Searches for markers that exchange names or move at some time, in one trial or in all: each pair and each marker at
/// its best time.
///
/// No run is needed: the predictions are at hand. Times are those of samples.
std::vector<EffectScore> scan_markers(const setup::Setup& setup, const FitData& data, const JointFit& fit,
                                      const statistics::NuisanceSpace& nuisance, const EffectFilter& allowed);

}  // namespace myo::diagnosis
