#pragma once

#include "commands/backend.hpp"
#include "experiment/experiment.hpp"

namespace myo::backend {

/// Fills in the effects, obstacles and parts of an experiment; those that the scene had are replaced.
///
/// @param surface  of the body [m]; its bounds give places to new effects
/// @param time_s   within the first trial [s], for new effects that are events
void show_declared(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface, double time_s,
                   ui::commands::Scene& scene);

}  // namespace myo::backend
