#pragma once

#include <vector>

#include "commands/check_view.hpp"
#include "project/finding.hpp"

namespace myo {

CheckState shown_state(CheckLevel level);

/// Findings as the workbench shows them, the worst first.
CheckRows check_rows(const std::vector<Finding>& findings);

}  // namespace myo
