#pragma once

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "measurement/recording.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::setup {

/// Checks that a recording is as large as the declared markers, and so in the unit that it states.
///
/// Distances between markers are compared with those of the declared positions, whatever the frame; a soft body may
/// stretch them by a factor of a few. A single marker is compared with the body: it moves by a few body lengths at
/// most.
///
/// @param surface    of the body [m]
/// @param recording  markers on the body in the order of declaration, then the fixed ones [m]
/// Errors: a size that only another unit explains; the message names the likely unit.
Result<void> check_recorded_size(const experiment::Experiment& experiment,
                                 const experiment::TrialDeclaration& declaration, const mesh::SurfaceMesh& surface,
                                 const measurement::Recording& recording);

}  // namespace myo::setup
