#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "inverse/marker_target.hpp"
#include "prediction/prediction.hpp"
#include "setup/setup.hpp"

namespace myo::prediction {

/// Measured marker motion of a trial in the compared form: positions, or displacements from the start.
///
/// @param until_s  last trial time to compare [s]
/// @return         3 x T per marker [m], mesh frame, from first_sample on; NaN where occluded. As seen from the mount
///                 where that moves, see declared_mount(): its turns must not be compared by displacements
inverse::MarkerTarget trial_target(const setup::Setup& setup, std::size_t trial, double until_s);

/// How the mount of a trial moves as recorded and by the declared effects; null: it stands still.
model::MountMotionPointer declared_mount(const setup::Setup& setup, std::size_t trial);

/// Prediction from the motion of the marker nodes alone; its trace is empty.
///
/// @param placement  registration, mesh to camera frame
TrialPrediction prediction_of(const setup::Setup& setup, std::size_t trial, const sensitivity::NodeMotion& motion,
                              const inverse::MarkerPlacement& placement = {});

/// Declared values with this registration and without levels, for a setup whose signals replace the levels.
ParameterValues placed_values(const setup::Setup& setup, const inverse::MarkerPlacement& placement);

/// Index of the named trial; of the first fit trial if the name is empty, or of the first one where none is.
///
/// Errors: no such trial (place "--trial"); suggests the closest name.
Result<std::size_t> find_trial(const experiment::Experiment& experiment, const std::string& name);

/// The setup reduced to one trial, with role fit.
setup::Setup with_one_trial(setup::Setup setup, std::size_t trial);

}  // namespace myo::prediction
