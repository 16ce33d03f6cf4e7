#pragma once

#include <Eigen/Core>

#include <vector>

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::ui::viewport {

/// The triangles that draw a surface: three node numbers each, never indexed on the graphics side, so that a shader
/// tells corners apart by gl_VertexID % 3.
///
/// The side of a triangle that lies inside an element's face is opposite its corner 1; the fourth triangle of a
/// quadratic face lies inside altogether. shaders/surface.vert relies on it.
struct DrawnSurface {
    int face_nodes = 3;        // 3, 4 or 6
    std::vector<int> corners;  // 3 per triangle
    bool closed = true;        // back faces are never seen

    std::size_t triangle_count() const { return corners.size() / 3; }
    /// Of each face of the body.
    int triangles_per_face() const { return face_nodes == 6 ? 4 : face_nodes - 2; }
};

DrawnSurface drawn_surface(const mesh::BoundaryFaces& faces);
DrawnSurface drawn_surface(const mesh::SurfaceMesh& surface);

inline constexpr int surface_floats = 8;

/// x, y, z, value and tint for each corner.
///
/// @param values  per node, or empty for zero
/// @param tints   red, green, blue and share per face of the body, 4 x faces, or empty for none
std::vector<float> surface_vertices(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions,
                                    const Eigen::VectorXd& values, const Eigen::Matrix4Xf& tints);

}  // namespace myo::ui::viewport
