#include "mesh/surface_mesh.hpp"

#include <array>
#include <cassert>

#include <Eigen/Geometry>

#include "mesh/cell_topology.hpp"

namespace myo::mesh {

Box bounding_box(const Eigen::Matrix3Xd& points) {
    assert(points.cols() > 0);
    return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()};
}

double enclosed_volume(const SurfaceMesh& surface) {
    if (surface.vertices.cols() == 0) return 0.0;
    // Relative to the centroid: far from the origin the terms would cancel and lose digits.
    const Eigen::Vector3d centre = surface.vertices.rowwise().mean();
    double volume = 0.0;
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        const Eigen::Vector3d a = surface.vertices.col(surface.triangles(0, t)) - centre;
        const Eigen::Vector3d b = surface.vertices.col(surface.triangles(1, t)) - centre;
        const Eigen::Vector3d c = surface.vertices.col(surface.triangles(2, t)) - centre;
        volume += a.dot(b.cross(c)) / 6.0;
    }
    return volume;
}

SurfaceMesh box_surface(const Box& box) {
    SurfaceMesh surface;
    surface.vertices.resize(3, 8);
    for (Eigen::Index i = 0; i < 8; ++i) {
        const auto& corner = hexahedron_corners[static_cast<std::size_t>(i)];
        for (Eigen::Index a = 0; a < 3; ++a) {
            surface.vertices(a, i) = corner[static_cast<std::size_t>(a)] == 1 ? box.highest[a] : box.lowest[a];
        }
    }
    surface.triangles.resize(3, 12);
    for (Eigen::Index f = 0; f < 6; ++f) {
        const auto& face = hexahedron_faces[static_cast<std::size_t>(f)];
        surface.triangles.col(2 * f) << face[0], face[1], face[2];
        surface.triangles.col(2 * f + 1) << face[0], face[2], face[3];
    }
    return surface;
}

}  // namespace myo::mesh
