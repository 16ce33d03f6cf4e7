#pragma once

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/backend.hpp"

namespace myo {

/// The declared fit of a scene with measured trials. Cancelled, it gives the best values so far; an error when there are none.
Result<SearchResult> calibrate_scene(const Scene& scene, const MeshedBody& body, const Settings& settings, const Progress& progress, const Backend::LiveSearch& live);

/// Signals of all muscles that follow none, beginning with those that are drawn. Cancelled likewise.
/// Errors: no such trial, knots closer than steps, no value between the bounds.
Result<SearchResult> optimize_scene(const Scene& scene, const MeshedBody& body, const Settings& settings, const OptimizeRequest& request, const Progress& progress,
                                    const Backend::LiveSearch& live);

}  // namespace myo
