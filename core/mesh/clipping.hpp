#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

using Polygon = std::vector<Eigen::Vector3d>;

/// The part of a flat convex polygon inside a box (Sutherland & Hodgman 1974); empty when nothing is left.
///
/// Inclusive: a corner within `tolerance` [m] of a box face counts as on it, so a polygon lying in a face is kept whole
/// while one that crosses is cut at the face itself.
Polygon clip_to_box(Polygon polygon, const Box& box, double tolerance);

struct ClippedVolume {
    double volume_m3 = 0.0;                                      // never negative
    Eigen::Vector3d moment_m4 = Eigen::Vector3d::Zero();         // integral of the position x
    Eigen::Matrix3d second_moment_m5 = Eigen::Matrix3d::Zero();  // integral of x x'

    Eigen::Vector3d centre_m() const { return moment_m4 / volume_m3; }
};

/// The part of a tetrahedron inside a box, exact: each of the six half-spaces cuts it into tetrahedra again. Corners 3
/// x 4, either orientation.
ClippedVolume tetrahedron_in_box(const Eigen::Matrix<double, 3, 4>& corners, const Box& box, double tolerance);

}  // namespace myo::mesh
