#include "mesh/boundary_surface.hpp"

#include <array>
#include <vector>

#include "mesh/cell_traits.hpp"

namespace myo::mesh {
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
    // Triangles of a face in positions of its own list of nodes.
    const std::vector<std::array<int, 3>>& triangles = cell_traits(mesh.type).face_triangles;
    const auto per_face = static_cast<Eigen::Index>(triangles.size());
    SurfaceMesh surface;
    surface.vertices = mesh.nodes(Eigen::all, used);
    surface.triangles.resize(3, per_face * faces.count());
    for (Eigen::Index f = 0; f < faces.count(); ++f)
        for (Eigen::Index t = 0; t < per_face; ++t)
            for (std::size_t i = 0; i < 3; ++i)
                surface.triangles(static_cast<Eigen::Index>(i), per_face * f + t) = number[static_cast<std::size_t>(
                    faces.nodes(triangles[static_cast<std::size_t>(t)][i], f))];
    return surface;
}

}  // namespace myo::mesh
