#pragma once

#include <vector>

#include "commands/check_view.hpp"
#include "project/finding.hpp"

namespace myo {

CheckState shown_state(CheckLevel level);

/// Findings as the workbench shows them, the worst first.
/// @param as_declared  see CheckedJob: what such a run leaves is for a fit to mend, not for a diagnosis
CheckRows check_rows(const std::vector<Finding>& findings, bool as_declared = false);

}  // namespace myo
