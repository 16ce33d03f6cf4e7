#pragma once

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/backend.hpp"

namespace myo::backend {

/// Fits the unknowns of a scene with measured trials.
///
/// @param body  displayed mesh; reused if it matches the settings
/// @param live  called after every evaluation, on this thread; may be empty
/// Errors: those of scene_setup(); no usable values. Cancelled, it returns the best values so far.
Result<ui::commands::SearchResult> calibrate_scene(const ui::commands::Scene& scene,
                                                   const ui::commands::MeshedBody& body,
                                                   const ui::commands::Settings& settings, const Progress& progress,
                                                   const ui::commands::Backend::LiveSearch& live);

/// Searches signals of all muscles that follow none, starting from the drawn ones.
///
/// @param request  trial, knot rate [Hz] and bounds of the target stretch
/// @param live     as in calibrate_scene()
/// Errors: no such trial, knots closer than steps, no value between the bounds. Cancelled as above.
Result<ui::commands::SearchResult> optimize_scene(const ui::commands::Scene& scene,
                                                  const ui::commands::MeshedBody& body,
                                                  const ui::commands::Settings& settings,
                                                  const ui::commands::OptimizeRequest& request,
                                                  const Progress& progress,
                                                  const ui::commands::Backend::LiveSearch& live);

}  // namespace myo::backend
