#include "viewport/drawn_surface.hpp"

#include <array>
#include <cassert>
#include <cmath>

namespace myo {

DrawnSurface drawn_surface(const BoundaryFaces& faces) {
    static constexpr std::array<int, 3> triangle{0, 1, 2};
    static constexpr std::array<int, 6> quadrilateral{0, 1, 2, 2, 3, 0};
    static constexpr std::array<int, 12> quadratic{5, 0, 3, 3, 1, 4, 4, 2, 5, 3, 4, 5};
    DrawnSurface surface;
    surface.face_nodes = static_cast<int>(faces.nodes.rows());
    assert(surface.face_nodes == 3 || surface.face_nodes == 4 || surface.face_nodes == 6);
    const auto add = [&](const auto& order) {
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

DrawnSurface drawn_surface(const SurfaceMesh& mesh) {
    DrawnSurface surface;
    surface.closed = false;
    surface.corners.assign(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size());
    return surface;
}

std::vector<float> surface_vertices(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions, const Eigen::VectorXd& values) {
    assert(values.size() == 0 || values.size() == positions.cols());
    std::vector<float> data(surface.corners.size() * 4);
    for (std::size_t i = 0; i < surface.corners.size(); ++i) {
        const int node = surface.corners[i];
        assert(node >= 0 && node < positions.cols());
        for (int k = 0; k < 3; ++k) data[4 * i + static_cast<std::size_t>(k)] = static_cast<float>(positions(k, node));
        data[4 * i + 3] = values.size() > 0 ? static_cast<float>(values[node]) : 0.0f;
    }
    return data;
}

}  // namespace myo
