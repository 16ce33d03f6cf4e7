#pragma once

#include "mesh/box_tree.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Nearest points of a surface.
class SurfaceDistance {
public:
    /// @param surface  copied; triangles without area are allowed
    explicit SurfaceDistance(const SurfaceMesh& surface);

    struct Nearest {
        int triangle = -1;
        Eigen::Vector3d point = Eigen::Vector3d::Zero();  // [m]
        double distance = 0.0;                            // [m]
    };
    /// Nearest point of the surface.
    Nearest nearest(const Eigen::Vector3d& point) const;
    /// Largest distance [m] of the corners, the middles of the sides and the centres of the triangles of another
    /// surface.
    double largest_from(const SurfaceMesh& other) const;

private:
    Eigen::Vector3d nearest_on(int triangle, const Eigen::Vector3d& point) const;

    SurfaceMesh surface_;
    BoxTree tree_;
};

/// Point of the segment from a to b nearest to a point; a segment without length is its end a.
Eigen::Vector3d nearest_in_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& point);

/// Point of a triangle nearest to a point. Triangles without area are allowed.
/// Source: Ericson, Real-Time Collision Detection, 2005, 5.1.5.
Eigen::Vector3d nearest_in_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                    const Eigen::Vector3d& point);

}  // namespace myo::mesh
