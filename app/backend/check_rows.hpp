#pragma once

#include <vector>

#include "check/finding.hpp"
#include "commands/check_view.hpp"

namespace myo::backend {

/// Colour of a level in the window: passed is green, doubtful amber, anything worse red.
ui::commands::CheckState shown_state(check::CheckLevel level);

/// Findings as the workbench displays them, worst first.
///
/// Rows of one colour keep the order of the findings. A check that the catalogue does not know has its id as question.
/// @param as_declared  see CheckedJob: the residual of such a run is to be reduced by a fit, not by a diagnosis
ui::commands::CheckRows check_rows(const std::vector<check::Finding>& findings, bool as_declared = false);

}  // namespace myo::backend
