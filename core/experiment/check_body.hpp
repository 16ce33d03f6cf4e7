#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::experiment {

/// Closed surface of the declared body: the box, or the surface file scaled, rotated and with coincident vertices
/// merged. Closed parts inside others are turned to face inward, see mesh::facing_parts().
///
/// @param warnings  sentences on defects of the file and on turned parts are added; may be null
/// @return          vertices [m], mesh frame; triangles oriented outward
/// Errors: a surface file that cannot be read, is open, is oriented inward or has parts that overlap; a body larger
/// than 10 m or smaller than 1 mm. Each error carries the key and either the line of the key or the place in the
/// surface file.
Result<mesh::SurfaceMesh> read_body_surface(const Experiment& experiment, std::vector<std::string>* warnings = nullptr);

/// Error for clamp and supports that hold the whole body, so that no degree of freedom remains.
///
/// @param key  of the box with which nothing is free any more: clamp.box_m or support[i].box_m
Error holds_whole_body(const Experiment& experiment, const std::string& key);

/// Checks clamp, supports, muscle boxes, load boxes and marker rest positions against the geometry of the body.
///
/// @param body  closed surface, outward, vertices [m], mesh frame
/// Errors, with key and line: a clamp, support or muscle box without material, one that holds the whole body, a load
/// box without surface, a rest position farther than max_standoff_m from the surface. Fixed markers are not attached to
/// the body and are not checked. Painted muscles and muscles along a line are checked on the mesh by muscle_groups().
Result<void> check_on_body(const Experiment& experiment, const mesh::SurfaceMesh& body);

}  // namespace myo::experiment
