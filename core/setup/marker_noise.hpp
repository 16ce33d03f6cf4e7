#pragma once

#include <vector>

#include "measurement/recording.hpp"
#include "setup/setup.hpp"

namespace myo::setup {

struct MarkerNoisePolicy {
    double assumed_m = 1e-4;  // without any estimate: typical of mocap cameras
};
inline constexpr MarkerNoisePolicy marker_noise_policy;

/// The recording of a trial with gaps where a person filled or smoothed it: those samples would show less noise than
/// the cameras have.
///
/// @param trial  with `measured` and `start_s`
measurement::Recording without_made_samples(const experiment::TrialDeclaration& declaration,
                                            const PreparedTrial& trial);

/// Sets the noise of each marker [m]: declared, or estimated per trial and pooled (rms). Markers without an estimate
/// get the mean of the others; if all trials are holds, all markers do. Never below the deviation that rounding
/// produces.
///
/// @param recordings  traces of the trials as measured; trials of `setup` with their rounding
/// @param setup  gets the noise, and warnings about it; must have a trial
void set_noise(const std::vector<measurement::Recording>& recordings, Setup& setup);

}  // namespace myo::setup
