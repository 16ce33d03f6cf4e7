#pragma once

#include "commands/backend.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::backend {

/// Picture of a body seen from obliquely above, for the start page: visible triangles, far ones first, scaled so that
/// the longer side of the picture is 1.
///
/// @param surface  closed, outward, vertices [m]
/// @return         no triangles for a surface that has none, or too many to be drawn small
ui::commands::ExamplePicture picture_of(const mesh::SurfaceMesh& surface);

}  // namespace myo::backend
