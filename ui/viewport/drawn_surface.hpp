#pragma once

#include <Eigen/Core>

#include <vector>

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::ui::viewport {

/// Triangles that draw a surface: three node numbers each. They are not indexed on the GPU, so that a shader can find
/// the corner of a vertex by gl_VertexID % 3.
///
/// The side of a triangle that lies inside an element's face is opposite its corner 1; the fourth triangle of a
/// quadratic face lies inside it completely. shaders/surface.vert relies on this to draw element edges only.
struct DrawnSurface {
    int face_nodes = 3;        // nodes of an element's face: 3, 4 or 6
    std::vector<int> corners;  // node numbers, 3 per triangle
    bool closed = true;        // closed surface: back faces are culled

    std::size_t triangle_count() const { return corners.size() / 3; }
    /// Triangles that draw one face of the body.
    int triangles_per_face() const { return face_nodes == 6 ? 4 : face_nodes - 2; }
};

/// Triangles of a body's boundary, face after face. Asserts faces of 3, 4 or 6 nodes.
DrawnSurface drawn_surface(const mesh::BoundaryFaces& faces);
/// Triangles of a surface that is not meshed yet; drawn from both sides, as it may be open.
DrawnSurface drawn_surface(const mesh::SurfaceMesh& surface);

/// Floats per vertex in surface_vertices(): position (3), value (1), tint (4).
inline constexpr int surface_floats = 8;

/// Vertex data of a surface: x, y, z [m], value and tint for each corner of each triangle.
///
/// @param positions  of the nodes, 3 x n [m]
/// @param values  per node, or empty for zero
/// @param tints  red, green, blue and opacity of the tint per face of the body, 4 x faces, or empty for none
std::vector<float> surface_vertices(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions,
                                    const Eigen::VectorXd& values, const Eigen::Matrix4Xf& tints);

}  // namespace myo::ui::viewport
