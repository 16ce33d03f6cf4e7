#pragma once

#include "base/result.hpp"
#include "experiment/body_queries.hpp"
#include "experiment/experiment.hpp"

namespace myo::experiment {

/// Checks chambers, tendons, parts and obstacles against the geometry of the body.
///
/// Errors, with key and line: a chamber's point in the material, outside the body or in a cavity that is not closed;
/// two chambers with one cavity; a tendon all of whose guides stand still; a box of a part without material; a body
/// that lies in an obstacle. Parts given by a file or a region are checked on the mesh.
Result<void> check_robot_parts_on_body(const Experiment& experiment, const BodyQueries& body);

/// Whether a guide of a tendon moves with the body: it lies in the material, or as close to the surface as a marker
/// may; one in the clamp box or farther away stands still.
bool guide_moves(const Experiment& experiment, const BodyQueries& body, const Eigen::Vector3d& guide_m);

}  // namespace myo::experiment
