#pragma once

#include <vector>

#include "effect/effect.hpp"

namespace myo::effect {

/// Point of the rest surface as a convex combination of nodes (shares >= 0, sum 1) of the cell behind it.
struct SurfacePlace {
    int cell = 0;  // cell behind the face
    std::vector<int> nodes;
    Eigen::VectorXd shares;                             // one per node
    Eigen::Vector3d point = Eigen::Vector3d::Zero();    // surface point nearest to the requested one [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  // outward unit normal
};
/// Surface point nearest to `near_m` [m, mesh frame].
SurfacePlace surface_place(const model::Body& body, const Eigen::Vector3d& near_m);

/// `count` face centres of the free surface far from each other, the one farthest from the clamp first [m].
/// Farthest-point sampling: any place on the surface is near one of them. Fewer if the surface has fewer faces.
std::vector<Eigen::Vector3d> spread_surface_points(const TrialContext& context, std::size_t count);

/// `count` cell centres far from each other, the one farthest from the clamp first [m].
/// Farthest-point sampling, as above. Fewer if the body has fewer cells.
std::vector<Eigen::Vector3d> spread_cells(const TrialContext& context, std::size_t count);

/// Centre of each cell in the rest shape, 3 x cells [m].
Eigen::Matrix3Xd cell_centres(const model::Body& body);

/// Coordinate axis and direction in which the body protrudes from its clamp.
struct ClampAxis {
    int axis = 0;
    double sign = 1.0;      // +1 or -1
    double begin_m = 0.0;   // coordinate of the last clamped plane
    double length_m = 0.0;  // from this plane to the free end of the body
    double held_m = 0.0;    // depth of the clamp; 0 if only a face is clamped

    /// Signed distance of a point in front of the last clamped plane [m]; negative within the clamp.
    double ahead(const Eigen::Vector3d& point_m) const { return sign * (point_m(axis) - begin_m); }
};
/// The axis along which the clamped nodes are farthest off-centre, relative to the size of the body.
/// Without clamped nodes length_m is the whole extent of the body, and held_m is 0.
ClampAxis clamp_axis(const TrialContext& context);

}  // namespace myo::effect
