#pragma once

#include <vector>

#include "check/finding.hpp"
#include "commands/check_view.hpp"

namespace myo::backend {

ui::commands::CheckState shown_state(check::CheckLevel level);

/// Findings as the workbench shows them, the worst first.
/// @param as_declared  see CheckedJob: what such a run leaves is for a fit to mend, not for a diagnosis
ui::commands::CheckRows check_rows(const std::vector<check::Finding>& findings, bool as_declared = false);

}  // namespace myo::backend
