#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "fem/element_block.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo {

/// What is asked of the mesh; what is left open is chosen for the body.
struct MeshRequest {
    std::optional<ElementKind> element;
    std::optional<double> resolution_m;   // edge length
};

struct StudyMesh {
    VolumeMesh mesh;
    ElementKind element = ElementKind::hex8;
    double resolution_m = 0.0;
    std::vector<std::string> warnings;
};

/// True when every triangle lies in a plane x, y or z = constant: such a body is filled by hexahedra exactly.
bool is_rectilinear(const SurfaceMesh& surface);

/// hex8 for rectilinear bodies, tet10 for all others.
ElementKind automatic_element(const SurfaceMesh& surface);

/// Edge length that resolves the body with about a thousand unknowns [m]: the cube root of its volume over 6 (hexahedra) or 3.
double automatic_resolution(const SurfaceMesh& surface, CellType type);

/// The part of a body that a clamp box holds. A box that reaches less than a hundredth of the body's extent into it from one
/// side is there to select that side's face: it ends at the face, or a finer mesh would hold more of the body than a coarse one.
Box held_part(const Box& clamp, const Box& body);

/// Meshes a closed surface. Hexahedra get grid planes at the body's own axis-aligned faces and at the clamp's, so that
/// dimensions and support are met exactly.
/// Errors: those of the meshers.
Result<StudyMesh> mesh_body(const SurfaceMesh& surface, const MeshRequest& request, const std::vector<Box>& regions,
                            const Progress& progress = {});

}  // namespace myo
