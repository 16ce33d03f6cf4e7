#include "mesh/polygon.hpp"

#include <Eigen/Geometry>

namespace myo::mesh {

std::vector<std::array<int, 3>> triangles_of(const std::vector<int>& polygon,
                                             const std::vector<Eigen::Vector3d>& vertices) {
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> rest = polygon;
    const auto x = [&](int v) -> const Eigen::Vector3d& { return vertices[static_cast<std::size_t>(v)]; };

    // Newell's method: twice the area vector of the polygon.
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < rest.size(); ++i) {
        normal += (x(rest[i]) - x(rest[0])).cross(x(rest[(i + 1) % rest.size()]) - x(rest[0]));
    }
    // Sign of the turn at b, seen along the normal.
    const auto turn = [&](int a, int b, int c) { return (x(b) - x(a)).cross(x(c) - x(a)).dot(normal); };
    // A convex corner whose triangle holds no other vertex of the polygon.
    const auto is_ear = [&](std::size_t i) {
        const std::size_t n = rest.size();
        const int a = rest[(i + n - 1) % n], b = rest[i], c = rest[(i + 1) % n];
        if (turn(a, b, c) <= 0.0) return false;
        for (const int p : rest) {
            if (p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
        }
        return true;
    };
    while (rest.size() > 3) {
        std::size_t ear = 0;
        // First ear in order of the vertices, so that the result is deterministic.
        while (ear < rest.size() && !is_ear(ear)) ++ear;
        // A self-intersecting polygon may have no ear. Any corner is cut then; check_surface() reports the
        // intersection.
        if (ear == rest.size()) ear = 1;
        const std::size_t n = rest.size();
        triangles.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (rest.size() == 3) triangles.push_back({rest[0], rest[1], rest[2]});
    return triangles;
}

}  // namespace myo::mesh
