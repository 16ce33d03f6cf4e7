#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Surface whose closed parts face as they must.
struct FacingParts {
    SurfaceMesh surface;
    std::vector<std::string> notes;  // one sentence per part that was turned
};

/// Turns closed parts of a surface that face the wrong way: a part inside another bounds a cavity and faces inward, a
/// part inside a cavity faces outward again.
///
/// An inner part that faces outward would be a solid inside a solid, which a body of one material does not have;
/// cavities are often exported like that.
///
/// @param surface  welded; returned as it is if it is open, not oriented or of one part
/// Errors: two parts that overlap, with the box of each.
Result<FacingParts> facing_parts(const SurfaceMesh& surface);

}  // namespace myo::mesh
