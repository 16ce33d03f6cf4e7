#include "viewport/drawn_surface.hpp"

#include <array>
#include <cassert>
#include <cmath>

namespace myo::ui::viewport {

DrawnSurface drawn_surface(const mesh::BoundaryFaces& faces) {
    // Corner orders of the triangles of a face. Corner 1 lies opposite the side inside the face, as surface.vert
    // expects.
    static constexpr std::array<int, 3> triangle{0, 1, 2};
    static constexpr std::array<int, 6> quadrilateral{0, 1, 2, 2, 3, 0};
    static constexpr std::array<int, 12> quadratic{5, 0, 3, 3, 1, 4, 4, 2, 5, 3, 4, 5};
    DrawnSurface surface;
    surface.face_nodes = static_cast<int>(faces.nodes.rows());
    assert(surface.face_nodes == 3 || surface.face_nodes == 4 || surface.face_nodes == 6);
    const auto add = [&](const auto& order) {
        // Three vertices per triangle, without an index buffer, as the header explains.
        surface.corners.reserve(order.size() * static_cast<std::size_t>(faces.count()));
        for (Eigen::Index f = 0; f < faces.count(); ++f) {
            for (const int corner : order) surface.corners.push_back(faces.nodes(corner, f));
        }
    };
    if (surface.face_nodes == 3) add(triangle);
    if (surface.face_nodes == 4) add(quadrilateral);
    if (surface.face_nodes == 6) add(quadratic);
    return surface;
}

DrawnSurface drawn_surface(const mesh::SurfaceMesh& mesh) {
    DrawnSurface surface;
    surface.closed = false;
    surface.corners.assign(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size());
    return surface;
}

std::vector<float> surface_vertices(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions,
                                    const Eigen::VectorXd& values, const Eigen::Matrix4Xf& tints) {
    assert(values.size() == 0 || values.size() == positions.cols());
    const auto corners_per_face = static_cast<std::size_t>(3 * surface.triangles_per_face());
    assert(tints.cols() == 0 || static_cast<std::size_t>(tints.cols()) * corners_per_face == surface.corners.size());
    std::vector<float> data(surface.corners.size() * surface_floats, 0.0f);
    // All eight floats of a vertex are interleaved, so one upload per frame suffices.
    for (std::size_t i = 0; i < surface.corners.size(); ++i) {
        const int node = surface.corners[i];
        assert(node >= 0 && node < positions.cols());
        float* const vertex = &data[surface_floats * i];
        for (int k = 0; k < 3; ++k) vertex[k] = static_cast<float>(positions(k, node));
        if (values.size() > 0) vertex[3] = static_cast<float>(values[node]);
        if (tints.cols() > 0)
            Eigen::Map<Eigen::Vector4f>(vertex + 4) = tints.col(static_cast<Eigen::Index>(i / corners_per_face));
    }
    return data;
}

}  // namespace myo::ui::viewport
