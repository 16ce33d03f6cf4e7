#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "fem/element_block.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"
#include "setup/default_mesh.hpp"

namespace myo::setup {

/// How hexahedra fill a body.
enum class Voxels {
    fitted,     // edges adapt so that the dimensions of the body and the clamp are met
    truncated,  // whole cubes of the edge length only, so the body shrinks; the published scheme, for comparison
};
/// Id of a scheme, as --voxels takes it.
std::string to_string(Voxels voxels);
/// All ids.
std::vector<std::string> voxels_ids();
/// Sets `voxels` to the scheme of an id; false, and unchanged, if there is none.
bool parse_voxels(const std::string& id, Voxels& voxels);

/// Requested mesh. Empty options are chosen from the shape of the body.
struct MeshRequest {
    std::optional<fem::ElementKind> element;  // empty: see automatic_element()
    std::optional<double> resolution_m;       // edge length [m]; empty: see automatic_edges(), finer across thin parts
    Voxels voxels = Voxels::fitted;
    double refinement = 1.0;  // factor on all edge lengths, automatic ones included
};

/// Mesh of a body with the choices that produced it.
struct BodyMesh {
    mesh::VolumeMesh mesh;  // rest nodes [m], mesh frame
    fem::ElementKind element = fem::ElementKind::hex8;
    double resolution_m = 0.0;          // nominal edge length [m], refinement included
    std::optional<Box> shrunk_from;     // bounds of the body if truncated voxels made the mesh smaller
    std::vector<std::string> warnings;  // quality of the mesh, and clamp faces that it does not meet
};

/// Point declared on the body, mapped to the mesh.
///
/// @return   [m]; `declared_m` unless the mesh shrank, then scaled with the bounding box
Eigen::Vector3d point_on_mesh(const BodyMesh& mesh, const Eigen::Vector3d& declared_m);

/// Box declared on the body, mapped to the mesh like point_on_mesh().
Box box_on_mesh(const BodyMesh& mesh, const Box& declared);

/// Part of the body that a clamp box holds.
///
/// A box that penetrates less than a hundredth of the body's extent from one side is meant to select that side's face.
/// Such a box is cut back to the face: otherwise a finer mesh would clamp more of the body than a coarse one.
///
/// @param clamp, body  declared box and bounds of the body [m], mesh frame
Box held_part(const Box& clamp, const Box& body);

/// Mesh of the body of an experiment: its own cells if it declares a volume mesh, else mesh_body() with the faces of
/// clamp and parts.
///
/// Linear tetrahedra of a file get nodes at the middles of their edges, unless tet4 is requested: they would lock.
/// @param surface  of the body
/// Errors: those of mesh_body(); a request that a volume mesh cannot meet.
Result<BodyMesh> mesh_of(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface,
                         const MeshRequest& request, const Progress& progress = {});

/// Meshes a closed surface.
///
/// Hexahedra get grid planes at the axis-aligned faces of body and regions, so dimensions and support are exact;
/// tetrahedra conform to the faces of the regions. Truncated voxels start at the face that a region holds, or at the
/// lowest.
///
/// @param regions  boxes [m] whose faces the mesh should meet, such as the clamp
/// Errors: an edge length that is not positive or exceeds the body; those of the meshers.
Result<BodyMesh> mesh_body(const mesh::SurfaceMesh& surface, const MeshRequest& request,
                           const std::vector<Box>& regions, const Progress& progress = {});

}  // namespace myo::setup
