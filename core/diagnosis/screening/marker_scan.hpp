#pragma once

#include <vector>

#include "diagnosis/screening/effect_scores.hpp"

namespace myo::diagnosis {

/// Scores exchanged marker names and slipped markers: each pair and each marker with its best onset, in one trial or in
/// all.
///
/// Uses the predictions of the fit, no run is needed. Onsets are times of samples.
std::vector<EffectScore> scan_markers(const setup::Setup& setup, const FitData& data, const JointFit& fit,
                                      const statistics::NuisanceSpace& nuisance, const EffectFilter& allowed,
                                      const ScreeningPolicy& policy);

}  // namespace myo::diagnosis
