#pragma once

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/backend.hpp"

namespace myo::backend {

/// The declared fit of a scene with measured trials. Cancelled, it gives the best values so far; an error when there
/// are none.
Result<ui::commands::SearchResult> calibrate_scene(const ui::commands::Scene& scene,
                                                   const ui::commands::MeshedBody& body,
                                                   const ui::commands::Settings& settings, const Progress& progress,
                                                   const ui::commands::Backend::LiveSearch& live);

/// Signals of all muscles that follow none, beginning with those that are drawn. Cancelled likewise.
/// Errors: no such trial, knots closer than steps, no value between the bounds.
Result<ui::commands::SearchResult> optimize_scene(const ui::commands::Scene& scene,
                                                  const ui::commands::MeshedBody& body,
                                                  const ui::commands::Settings& settings,
                                                  const ui::commands::OptimizeRequest& request,
                                                  const Progress& progress,
                                                  const ui::commands::Backend::LiveSearch& live);

}  // namespace myo::backend
