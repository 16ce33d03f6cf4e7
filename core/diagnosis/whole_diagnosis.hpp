#pragma once

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// diagnose(), and where its verdict is unknown, the missing force: infer_missing_force() with its time among the
/// costs.
Diagnosis whole_diagnosis(const setup::Setup& setup, const DiagnoseSettings& settings, const Progress& progress = {},
                          const std::function<void(const Diagnosis&)>& live = {});

}  // namespace myo::diagnosis
