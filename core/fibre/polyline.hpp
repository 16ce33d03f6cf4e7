#pragma once

#include <Eigen/Core>

namespace myo::fibre {

/// Segments end to end: points 3 x n [m], n >= 2, neighbours apart.
struct Polyline {
    Eigen::Matrix3Xd points_m;

    Eigen::Index segment_count() const { return points_m.cols() - 1; }
    double length_m() const;
};

/// A point beside the line.
struct BesideLine {
    double distance_m = 0.0;  // from the line; beyond an end from the end segment's straight continuation
    double
        inward_m = 0.0;  // from the flat that ends the line, positive on the line's side; infinite where no end is near
    Eigen::Vector3d tangent;  // of the nearest segment; half-way at a corner. Unit
    Eigen::Vector3d away;     // from the line towards the point; unit, zero on the line
};
BesideLine beside_line(const Polyline& line, const Eigen::Vector3d& x);

/// How deep x lies in the tube of this radius about the line [m]: the tube ends flat and is round at corners. Negative
/// outside.
double depth_in_tube(const BesideLine& beside, double radius_m);

}  // namespace myo::fibre
