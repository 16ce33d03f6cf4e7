#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "inverse/marker_target.hpp"
#include "project/prediction.hpp"
#include "project/study.hpp"

namespace myo {

/// Where the markers of a trial were seen, as they are compared: positions, or displacements from the start. Nowhere asked for
/// before the start, after `until_s`, and where a marker was occluded.
MarkerTarget trial_target(const Study& study, std::size_t trial, double until_s);

/// A prediction from the motion of the markers' nodes alone: its trace holds no states.
TrialPrediction prediction_of(const Study& study, std::size_t trial, const NodeMotion& motion,
                              const MarkerPlacement& placement = {});

/// The declared values of a study whose signals have taken the place of levels, seen with this placement.
StudyValues placed_values(const Study& study, const MarkerPlacement& placement);

/// The index of the named trial, or of the first fit trial when the name is empty.
/// Error: no such trial; names the nearest.
Result<std::size_t> find_trial(const Experiment& experiment, const std::string& name);

/// The study of one trial alone, as one to be fitted.
Study with_one_trial(Study study, std::size_t trial);

}  // namespace myo
