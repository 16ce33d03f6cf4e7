#pragma once

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/backend.hpp"

namespace myo::backend {

/// Fits the unknowns of a scene to its trials of role fit.
///
/// @param body  displayed mesh; reused if it matches the settings, otherwise the body is meshed
/// @param live  called after every evaluation, on this thread; may be empty
/// @return      fitted values as settings and rows, the run with them, its checks and the page
/// Errors: those of scene_setup(); no trial of role fit; times in another unit than seconds; no usable values.
/// Cancelled, it returns the best values so far.
Result<ui::commands::SearchResult> calibrate_scene(const ui::commands::Scene& scene,
                                                   const ui::commands::MeshedBody& body,
                                                   const ui::commands::Settings& settings, const Progress& progress,
                                                   const ui::commands::Backend::LiveSearch& live);

/// Searches signals of all muscles that follow none, of chambers and of tendons, starting from the drawn ones, and what
/// the request seeks of the body: fibre directions, painted weights, moduli.
///
/// @param request  trial, what is sought, knot rate [Hz] (lowered to one knot per step), bounds of the target stretch
/// @param live     as in calibrate_scene()
/// Errors: no such trial; nothing sought; those of calibration::actuation_problem(), body_design() and
/// edited_declaration(). Cancelled as above.
Result<ui::commands::SearchResult> optimize_scene(const ui::commands::Scene& scene,
                                                  const ui::commands::MeshedBody& body,
                                                  const ui::commands::Settings& settings,
                                                  const ui::commands::OptimizeRequest& request,
                                                  const Progress& progress,
                                                  const ui::commands::Backend::LiveSearch& live);

}  // namespace myo::backend
