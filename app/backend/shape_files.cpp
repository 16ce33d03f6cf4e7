#include "backend/shape_files.hpp"

#include <algorithm>
#include <cassert>

#include "base/letter_case.hpp"
#include "mesh/boundary_surface.hpp"
#include "mesh/vtk_writer.hpp"
#include "results/glb_file.hpp"

namespace myo::backend {
namespace {

using Eigen::Index;

/// Numbers of the nodes on the boundary, ascending: the vertices of boundary_surface().
std::vector<Index> boundary_nodes(const mesh::BoundaryFaces& boundary) {
    std::vector<Index> nodes(boundary.nodes.data(), boundary.nodes.data() + boundary.nodes.size());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace

Result<void> write_shape_file(const std::filesystem::path& file, const ui::commands::MeshedBody& body,
                              const ui::commands::ShapeFrame& frame) {
    // The frame must be of this mesh: a mesh that was made since has other nodes.
    assert(frame.positions_m.cols() == body.mesh.node_count());
    mesh::VolumeMesh deformed = body.mesh;
    deformed.nodes = frame.positions_m;
    const std::string ending = lower_case(file.extension().string());
    // Only .vtu holds the volume and fields; the other formats take the surface.
    if (ending == ".vtu") {
        std::vector<mesh::MeshField> fields{{"displacement", frame.positions_m - body.mesh.nodes}};
        if (frame.values.size() > 0) fields.push_back({frame.field, frame.values.transpose()});
        return mesh::write_vtu(file, deformed, fields);
    }
    const mesh::SurfaceMesh surface = mesh::boundary_surface(deformed);
    // STL stores no unit, hence one of the user's choice.
    if (ending == ".stl") return mesh::write_stl(file, surface, frame.metres_per_unit);
    if (ending != ".glb") return Error{"has none of the extensions .vtu, .stl and .glb", file.string()};
    Eigen::Matrix3Xf colours;
    // Colours are per node of the mesh; the surface has the nodes of the boundary only.
    if (frame.colours.cols() > 0) colours = frame.colours(Eigen::all, boundary_nodes(body.boundary));
    return results::write_glb(file, surface, colours);
}

}  // namespace myo::backend
