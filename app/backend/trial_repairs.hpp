#pragma once

#include "commands/trace_repairs.hpp"
#include "experiment/experiment.hpp"
#include "setup/setup.hpp"

namespace myo::backend {

/// Repairs that a trial declares, as the window shows them: in words, with times of the trial instead of the file.
ui::commands::TraceRepairs shown_repairs(const experiment::TrialDeclaration& declared,
                                         const setup::PreparedTrial& trial);

}  // namespace myo::backend
