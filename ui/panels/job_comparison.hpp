#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Whether at least one ended job is selected for comparison.
bool compares_jobs(const commands::WorkbenchState& state);

/// Draws a table of the compared jobs and the present settings: errors, and the settings in which they differ.
void draw_job_comparison(PanelContext& context);

}  // namespace myo::ui::panels
