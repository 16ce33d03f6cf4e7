#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "fem/element_block.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"
#include "setup/default_mesh.hpp"

namespace myo::setup {

/// How hexahedra fill a body.
enum class Voxels {
    fitted,     // edges adapt so that the body's and the clamp's dimensions are met
    truncated,  // cubes of exactly the edge length, whole ones only: the body shrinks. As published, for comparison
};
std::string to_string(Voxels voxels);
std::vector<std::string> voxels_ids();
/// False when there is no way of this name.
bool parse_voxels(const std::string& id, Voxels& voxels);

/// What is asked of the mesh; what is left open is chosen for the body.
struct MeshRequest {
    std::optional<fem::ElementKind> element;
    std::optional<double> resolution_m;  // edge length; left open, cells are finer across thin parts
    Voxels voxels = Voxels::fitted;
    double refinement = 1.0;  // all edges times this, those that were left open as well
};

struct BodyMesh {
    mesh::VolumeMesh mesh;
    fem::ElementKind element = fem::ElementKind::hex8;
    double resolution_m = 0.0;
    std::optional<Box> shrunk_from;  // the body's bounds, where truncated voxels left a smaller mesh
    std::vector<std::string> warnings;
};

/// A place declared on the body, moved to the same part of a mesh that shrank; otherwise the place itself.
Eigen::Vector3d point_on_mesh(const BodyMesh& mesh, const Eigen::Vector3d& declared_m);

/// A box declared on the body, moved to the same part of a mesh that shrank; otherwise the box itself.
Box box_on_mesh(const BodyMesh& mesh, const Box& declared);

/// The part of a body that a clamp box holds. A box that reaches less than a hundredth of the body's extent into it
/// from one side is there to select that side's face: it ends at the face, or a finer mesh would hold more of the body
/// than a coarse one.
Box held_part(const Box& clamp, const Box& body);

/// Meshes a closed surface. Hexahedra get grid planes at the body's own axis-aligned faces and at the regions', so that
/// dimensions and support are met exactly; tetrahedra meet the regions' faces. Truncated ones start at the face that a
/// region holds, or at the lowest. Errors: those of the meshers.
Result<BodyMesh> mesh_body(const mesh::SurfaceMesh& surface, const MeshRequest& request,
                           const std::vector<Box>& regions, const Progress& progress = {});

}  // namespace myo::setup
