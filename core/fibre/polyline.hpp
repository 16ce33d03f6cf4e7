#pragma once

#include <Eigen/Core>

namespace myo::fibre {

/// Polyline with points 3 x n [m], n >= 2, successive points distinct.
struct Polyline {
    Eigen::Matrix3Xd points_m;

    /// Number of segments, n - 1.
    Eigen::Index segment_count() const { return points_m.cols() - 1; }
    /// Total length.
    double length_m() const;
};

/// Position of a point relative to a polyline.
struct BesideLine {
    double distance_m = 0.0;  // distance from the line; beyond an end from the extended end segment
    double inward_m = 0.0;    // signed distance from the nearest end plane, positive inside; infinite if no end is near
    Eigen::Vector3d tangent;  // unit; of the nearest segment, bisector at a corner
    Eigen::Vector3d away;     // unit vector from the line to the point; zero on the line
};
/// Position of x [m] relative to the nearest segment of the line.
BesideLine beside_line(const Polyline& line, const Eigen::Vector3d& x);

/// Depth of a point in the tube of the given radius about the line [m]; negative outside. The tube has flat ends and is
/// round at corners.
double depth_in_tube(const BesideLine& beside, double radius_m);

}  // namespace myo::fibre
