#pragma once

#include "loop/diagnosis.hpp"

namespace myo {

/// diagnose(), and where its verdict is unknown, the missing force: infer_missing_force() with its time among the costs.
Diagnosis whole_diagnosis(const Study& study, const DiagnoseSettings& settings, const Progress& progress = {},
                          const std::function<void(const Diagnosis&)>& live = {});

}  // namespace myo
