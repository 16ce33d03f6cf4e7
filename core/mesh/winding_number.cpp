#include "mesh/winding_number.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace myo::mesh {

double winding_number(const SurfaceMesh& surface, const Eigen::Vector3d& point) {
    double angle = 0.0;
    // Signed solid angle of a triangle seen from the point.
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        const auto corner = [&](int i) -> Eigen::Vector3d {
            return surface.vertices.col(surface.triangles(i, t)) - point;
        };
        const Eigen::Vector3d a = corner(0), b = corner(1), c = corner(2);
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    // Every direction from a point inside meets the surface once more outward than inward: 4 pi in sum.
    return angle / (4.0 * std::numbers::pi);
}

}  // namespace myo::mesh
