#pragma once

#include "commands/backend.hpp"
#include "experiment/experiment.hpp"

namespace myo::backend {

/// Fills in the effects, obstacles and parts of an experiment.
///
/// @param time_s  within the first trial, for new effects that are events
void show_declared(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface, double time_s,
                   ui::commands::Scene& scene);

}  // namespace myo::backend
