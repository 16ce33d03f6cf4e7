#pragma once

#include <memory>
#include <vector>

#include "mesh/surface_distance.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

struct PatchPolicy {
    double max_angle_deg = 20.0;  // between normals of one face of a body: a round of 16 sides counts as sides
    double margin = 0.01;         // of the box around a patch, over the longest side of the body: a layer of cells
};
inline constexpr PatchPolicy patch_policy;

/// Faces of a body in the plain sense: connected triangles that face almost the same way.
/// The box around one of them is what a person selects in the window by pointing at it.
class SurfacePatches {
public:
    /// @param surface  welded; copied
    explicit SurfacePatches(const SurfaceMesh& surface);

    /// Nearest point of the surface.
    SurfaceDistance::Nearest nearest(const Eigen::Vector3d& point) const { return distance_.nearest(point); }
    /// Outward unit normal of a triangle.
    Eigen::Vector3d normal(int triangle) const { return normals_.col(triangle); }
    /// Triangles that are connected with `triangle` and whose normals differ from its normal by at most
    /// patch_policy.max_angle_deg, ascending.
    std::vector<int> around(int triangle) const;
    /// Bounding box of triangles, with patch_policy.margin on all sides [m].
    Box box_around(const std::vector<int>& triangles) const;
    /// Number of the closed part of the surface that a triangle belongs to.
    int part(int triangle) const { return part_[static_cast<std::size_t>(triangle)]; }

private:
    SurfaceMesh surface_;
    SurfaceDistance distance_;
    Eigen::Matrix3Xd normals_;               // unit, one per triangle
    std::vector<std::vector<int>> meeting_;  // per triangle: those that share an edge with it
    std::vector<int> part_;
};

}  // namespace myo::mesh
