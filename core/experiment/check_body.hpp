#pragma once

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::experiment {

/// The declared body's surface in the mesh frame [m]: the box, or the STL scaled, rotated and with its vertices joined.
///
/// Errors: an STL that cannot be read, is open or turned inward; a body larger than 10 m or smaller than 1 mm. Each
/// with the key, at the key's line or the place in the STL.
Result<mesh::SurfaceMesh> read_body_surface(const Experiment& experiment);

/// The error of a clamp that leaves nothing of the body to move.
Error holds_whole_body(const Experiment& experiment);

/// Clamp, muscles, loads and rest positions against the body.
///
/// @param body  closed and outward, mesh frame
/// Errors, with key and line: a clamp or muscle box without material, a clamp box that holds the whole body, a load box
/// without surface, a rest position farther than max_standoff_m from the surface. Fixed markers are not on the body and
/// may be anywhere. Muscles painted or along a line are looked at where they meet a mesh, by muscle_groups().
Result<void> check_on_body(const Experiment& experiment, const mesh::SurfaceMesh& body);

}  // namespace myo::experiment
