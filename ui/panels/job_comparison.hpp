#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Whether an ended job is compared.
bool compares_jobs(const commands::WorkbenchState& state);

/// Errors of the compared jobs and of the present settings side by side, and the settings in which they differ.
void draw_job_comparison(PanelContext& context);

}  // namespace myo::ui::panels
