#include "mesh/boundary_surface.hpp"

#include <vector>

namespace myo::mesh {
namespace {

/// Triangles of one face by local node numbers. A quadratic face gives three corner triangles and the one between its
/// mid-side nodes.
std::vector<int> triangles_of_face(CellType type) {
    if (type == CellType::hex8) return {0, 1, 2, 2, 3, 0};
    if (type == CellType::tet4) return {0, 1, 2};
    return {5, 0, 3, 3, 1, 4, 4, 2, 5, 3, 4, 5};
}

}  // namespace

SurfaceMesh boundary_surface(const VolumeMesh& mesh) {
    const BoundaryFaces faces = boundary_faces(mesh);
    // Boundary nodes are renumbered in ascending order.
    std::vector<int> number(static_cast<std::size_t>(mesh.node_count()), -1);
    for (const int node : faces.nodes.reshaped()) number[static_cast<std::size_t>(node)] = 0;
    std::vector<Eigen::Index> used;
    for (std::size_t node = 0; node < number.size(); ++node) {
        if (number[node] < 0) continue;
        number[node] = static_cast<int>(used.size());
        used.push_back(static_cast<Eigen::Index>(node));
    }
    const std::vector<int> corners = triangles_of_face(mesh.type);
    const auto per_face = static_cast<Eigen::Index>(corners.size()) / 3;
    SurfaceMesh surface;
    surface.vertices = mesh.nodes(Eigen::all, used);
    surface.triangles.resize(3, per_face * faces.count());
    for (Eigen::Index f = 0; f < faces.count(); ++f)
        for (Eigen::Index k = 0; k < 3 * per_face; ++k)
            surface.triangles(
                k % 3,
                per_face * f +
                    k / 3) = number[static_cast<std::size_t>(faces.nodes(corners[static_cast<std::size_t>(k)], f))];
    return surface;
}

}  // namespace myo::mesh
