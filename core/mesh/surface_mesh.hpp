#pragma once

#include <Eigen/Core>

namespace myo {

/// A triangulated surface: vertices 3 x n [m], mesh frame; triangles 3 x m, 0-based, outward by the right hand rule.
struct SurfaceMesh {
    Eigen::Matrix3Xd vertices;
    Eigen::Matrix3Xi triangles;
};

/// Axis-aligned box; also the schema's `box_m`.
struct Box {
    Eigen::Vector3d lowest = Eigen::Vector3d::Zero();
    Eigen::Vector3d highest = Eigen::Vector3d::Zero();

    bool contains(const Eigen::Vector3d& point) const {
        return (point.array() >= lowest.array()).all() && (point.array() <= highest.array()).all();
    }
    Eigen::Vector3d size() const { return highest - lowest; }
};

/// Bounding box. Asserts that the surface has vertices.
Box bounding_box(const Eigen::Matrix3Xd& points);

/// Volume enclosed by a closed outward surface [m3] (divergence theorem); negative when oriented inward.
double enclosed_volume(const SurfaceMesh& surface);

/// The 12 triangles of a box.
SurfaceMesh box_surface(const Box& box);

}  // namespace myo
