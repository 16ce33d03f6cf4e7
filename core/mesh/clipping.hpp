#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Vertices of a flat polygon in order [m].
using Polygon = std::vector<Eigen::Vector3d>;

/// Part of a flat convex polygon inside a box (Sutherland & Hodgman 1974); empty if nothing is left.
///
/// A vertex within `tolerance` [m] of a side counts as on it. A polygon lying in a side is thus kept completely, and
/// one that crosses is cut at the side itself.
Polygon clip_to_box(Polygon polygon, const Box& box, double tolerance);

/// Volume with first and second moments.
struct ClippedVolume {
    double volume_m3 = 0.0;                                      // never negative
    Eigen::Vector3d moment_m4 = Eigen::Vector3d::Zero();         // integral of the position x
    Eigen::Matrix3d second_moment_m5 = Eigen::Matrix3d::Zero();  // integral of x x'

    /// Centre of volume; the volume must not be zero.
    Eigen::Vector3d centre_m() const { return moment_m4 / volume_m3; }
};

/// Part of a tetrahedron inside a box, exact: each of the six half-spaces cuts it into tetrahedra again.
///
/// @param corners    3 x 4 [m], either orientation
/// @param tolerance  [m], see clip_to_box()
/// @return           zero volume if they do not overlap
ClippedVolume tetrahedron_in_box(const Eigen::Matrix<double, 3, 4>& corners, const Box& box, double tolerance);

}  // namespace myo::mesh
