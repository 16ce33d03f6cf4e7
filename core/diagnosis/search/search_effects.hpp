#pragma once

#include "diagnosis/diagnosis_work.hpp"

namespace myo::diagnosis {

/// Scores all effects that may be named, and fits the best of them until one explains the residual: from their best
/// probes, from other places and axes, by large probes. False: cancelled.
bool search_effects(DiagnosisWork& work);

}  // namespace myo::diagnosis
