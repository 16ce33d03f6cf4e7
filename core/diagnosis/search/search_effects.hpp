#pragma once

#include "diagnosis/diagnosis_work.hpp"

namespace myo::diagnosis {

/// Scores all effects that may be named, and fits the best until one explains the residual: from their best probes,
/// from other places and axes, and from large probes. Returns false if cancelled.
bool search_effects(DiagnosisWork& work);

}  // namespace myo::diagnosis
