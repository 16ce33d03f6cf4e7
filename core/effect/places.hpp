#pragma once

#include <vector>

#include "effect/effect.hpp"

namespace myo::effect {

/// A point of the rest surface as a sum over nodes of the cell behind it, shares not negative and adding up to 1.
struct SurfacePlace {
    int cell = 0;
    std::vector<int> nodes;
    Eigen::VectorXd shares;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();    // nearest to the one asked for [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  // outward
};
SurfacePlace surface_place(const model::Body& body, const Eigen::Vector3d& near_m);

/// Points of the free surface far from each other, the farthest from the clamp first [m].
std::vector<Eigen::Vector3d> spread_surface_points(const EffectSite& site, std::size_t count);

/// Centres of cells far from each other [m].
std::vector<Eigen::Vector3d> spread_cells(const EffectSite& site, std::size_t count);

/// Centre of each cell at rest, 3 x m [m].
Eigen::Matrix3Xd cell_centres(const model::Body& body);

/// Along which coordinate, and in which direction, the body stands out of its clamp.
struct ClampAxis {
    int axis = 0;
    double sign = 1.0;
    double begin_m = 0.0;   // coordinate of the clamp's last held plane
    double length_m = 0.0;  // from there to the body's end
    double held_m = 0.0;    // depth of the clamp

    /// How far in front of the last held plane a point lies; negative within the clamp [m].
    double ahead(const Eigen::Vector3d& point_m) const { return sign * (point_m(axis) - begin_m); }
};
ClampAxis clamp_axis(const EffectSite& site);

}  // namespace myo::effect
