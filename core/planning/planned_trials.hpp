#pragma once

#include "prediction/prediction.hpp"
#include "setup/setup.hpp"

namespace myo::planning {

/// The setup with every trial without a recording as a trial to fit, as if all its markers were seen at every sample.
///
/// What such a trial "measured" is the origin until with_motion() replaces it: differences between predictions do not
/// depend on it.
setup::Setup with_planned_trials(setup::Setup setup);

/// The setup with time steps lengthened as in a diagnosis: while predictions change by at most this many noise levels.
/// Requested steps are kept.
/// @param most_change  rms [noise levels]
setup::Setup with_longer_steps(setup::Setup setup, const prediction::ParameterValues& values, double most_change,
                               const Progress& progress);

/// True if a trial of the setup has a recording to fit.
bool has_fit_recording(const setup::Setup& setup);

/// The setup with the motion that these values predict as the recording of every fit trial, without noise.
///
/// Errors: a trial does not run.
Result<setup::Setup> with_motion(setup::Setup setup, const prediction::ParameterValues& values,
                                 const Progress& progress);

}  // namespace myo::planning
