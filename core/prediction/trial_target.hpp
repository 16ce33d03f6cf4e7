#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "inverse/marker_target.hpp"
#include "prediction/prediction.hpp"
#include "setup/setup.hpp"

namespace myo::prediction {

/// Where the markers of a trial were seen, as they are compared: positions, or displacements from the start. Nowhere
/// asked for before the start, after `until_s`, and where a marker was occluded.
inverse::MarkerTarget trial_target(const setup::Setup& setup, std::size_t trial, double until_s);

/// A prediction from the motion of the markers' nodes alone: its trace holds no states.
TrialPrediction prediction_of(const setup::Setup& setup, std::size_t trial, const sensitivity::NodeMotion& motion,
                              const inverse::MarkerPlacement& placement = {});

/// The declared values of a setup whose signals have taken the place of levels, seen with this placement.
ParameterValues placed_values(const setup::Setup& setup, const inverse::MarkerPlacement& placement);

/// The index of the named trial, or of the first fit trial when the name is empty.
/// Error: no such trial; names the nearest.
Result<std::size_t> find_trial(const experiment::Experiment& experiment, const std::string& name);

/// The setup of one trial alone, as one to be fitted.
setup::Setup with_one_trial(setup::Setup setup, std::size_t trial);

}  // namespace myo::prediction
