#include "mesh/surface_patch.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "mesh/surface_topology.hpp"

namespace myo::mesh {
namespace {

/// Outward unit normals, 3 x triangles; zero for a triangle without area.
Eigen::Matrix3Xd unit_normals(const SurfaceMesh& surface) {
    Eigen::Matrix3Xd normals(3, surface.triangles.cols());
    for (Eigen::Index t = 0; t < normals.cols(); ++t) {
        const Eigen::Matrix3d X = surface.vertices(Eigen::all, surface.triangles.col(t));
        normals.col(t) = (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0)).normalized();
    }
    return normals;
}

/// Per triangle the triangles that share an edge with it.
std::vector<std::vector<int>> triangles_at_edges(const SurfaceMesh& surface) {
    std::map<std::pair<int, int>, std::vector<int>> at_edge;
    for (int t = 0; t < static_cast<int>(surface.triangles.cols()); ++t)
        for (int k = 0; k < 3; ++k)
            at_edge[std::minmax(surface.triangles(k, t), surface.triangles((k + 1) % 3, t))].push_back(t);
    std::vector<std::vector<int>> meeting(static_cast<std::size_t>(surface.triangles.cols()));
    for (const auto& [edge, triangles] : at_edge)
        for (const int a : triangles)
            for (const int b : triangles)
                if (a != b) meeting[static_cast<std::size_t>(a)].push_back(b);
    return meeting;
}

}  // namespace

SurfacePatches::SurfacePatches(const SurfaceMesh& surface)
    : surface_(surface),
      distance_(surface),
      normals_(unit_normals(surface)),
      meeting_(triangles_at_edges(surface)),
      part_(surface_topology(surface).part) {}

std::vector<int> SurfacePatches::around(int triangle) const {
    const double least_cosine = std::cos(patch_policy.max_angle_deg * std::numbers::pi / 180.0);
    std::vector<char> taken(meeting_.size(), 0);
    std::vector<int> patch{triangle};
    taken[static_cast<std::size_t>(triangle)] = 1;
    for (std::size_t next = 0; next < patch.size(); ++next)
        for (const int other : meeting_[static_cast<std::size_t>(patch[next])]) {
            char& has = taken[static_cast<std::size_t>(other)];
            // Compared with the first triangle, not the neighbour: a round would otherwise be one patch.
            if (has != 0 || normals_.col(other).dot(normals_.col(triangle)) < least_cosine) continue;
            has = 1;
            patch.push_back(other);
        }
    std::sort(patch.begin(), patch.end());
    return patch;
}

Box SurfacePatches::box_around(const std::vector<int>& triangles) const {
    const double margin = patch_policy.margin * bounding_box(surface_.vertices).size().maxCoeff();
    Box box{surface_.vertices.col(surface_.triangles(0, triangles.front())),
            surface_.vertices.col(surface_.triangles(0, triangles.front()))};
    for (const int t : triangles)
        for (const int corner : surface_.triangles.col(t)) {
            box.lowest = box.lowest.cwiseMin(surface_.vertices.col(corner));
            box.highest = box.highest.cwiseMax(surface_.vertices.col(corner));
        }
    return {box.lowest.array() - margin, box.highest.array() + margin};
}

}  // namespace myo::mesh
