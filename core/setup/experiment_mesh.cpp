#include "experiment/read_experiment.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/quality.hpp"
#include "mesh/volume_reader.hpp"
#include "setup/body_mesh.hpp"
#include "setup/parts.hpp"

namespace myo::setup {
namespace {

/// The cells of a declared volume mesh, in m and turned to the mesh frame.
Result<BodyMesh> own_cells(const experiment::Experiment& experiment, const experiment::VolumeGeometry& declared,
                           const MeshRequest& request) {
    Result<mesh::VolumeMesh> cells = mesh::read_volume(declared.file, declared.metres_per_unit);
    if (!cells) return Error{"geometry.file: " + cells.error().what, cells.error().where};
    if (request.resolution_m || request.refinement != 1.0)
        return experiment::declaration_error(
            experiment, "geometry.kind", "a volume mesh is used as it is: leave the edge length (--resolution) out");
    BodyMesh made;
    cells->nodes = declared.rotation * cells->nodes;
    // Linear tetrahedra lock in bending of nearly incompressible material, so they become quadratic unless asked for.
    const mesh::CellType wanted = request.element                       ? fem::cell_type(*request.element)
                                  : cells->type == mesh::CellType::tet4 ? mesh::CellType::tet10
                                                                        : cells->type;
    made.mesh = wanted == mesh::CellType::tet10 && cells->type == mesh::CellType::tet4 ? mesh::to_tet10(*cells)
                                                                                       : std::move(*cells);
    if (made.mesh.type != wanted)
        return experiment::declaration_error(experiment, "geometry.file",
                                             "holds " + to_string(made.mesh.type) +
                                                 " cells, which are used as they "
                                                 "are; the element (--element) asks for " +
                                                 to_string(wanted));
    made.element = request.element.value_or(fem::default_element(made.mesh.type));
    made.resolution_m = mesh::mean_edge_length(made.mesh);
    for (const std::string& message : mesh::mesh_quality(made.mesh, nullptr).messages) made.warnings.push_back(message);
    return made;
}

}  // namespace

Result<BodyMesh> mesh_of(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface,
                         const MeshRequest& request, const Progress& progress) {
    if (const auto* volume = std::get_if<experiment::VolumeGeometry>(&experiment.geometry))
        return own_cells(experiment, *volume, request);
    std::vector<Box> regions = part_boxes(experiment);
    const Box bounds = mesh::bounding_box(surface.vertices);
    // The clamp first: planes too close to an existing one are left out, and the length of the clamp matters most.
    if (experiment::has_clamp(experiment)) regions.insert(regions.begin(), held_part(experiment.clamp_box_m, bounds));
    for (const experiment::SupportDeclaration& support : experiment.supports)
        regions.push_back(held_part(support.box_m, bounds));
    return mesh_body(surface, request, regions, progress);
}

}  // namespace myo::setup
