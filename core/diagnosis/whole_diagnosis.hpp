#pragma once

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// diagnose(), followed by infer_missing_force() if the verdict is `unknown`; its time is added to the costs.
/// What the command line and the window run; parameters as for diagnose().
Diagnosis whole_diagnosis(const setup::Setup& setup, const DiagnoseSettings& settings, const Progress& progress = {},
                          const std::function<void(const Diagnosis&)>& live = {});

}  // namespace myo::diagnosis
