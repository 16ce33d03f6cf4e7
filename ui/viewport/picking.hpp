#pragma once

#include <Eigen/Core>

#include <optional>

#include "viewport/camera.hpp"
#include "viewport/drawn_surface.hpp"

namespace myo::ui::viewport {

/// A half-line from the eye through a pixel, in the world frame.
struct Ray {
    Eigen::Vector3d origin_m;   // the eye; for a parallel projection a point before the scene [m]
    Eigen::Vector3d direction;  // unit
};
/// The ray through a pixel, counted from the upper left corner of the view.
Ray ray_through(const Camera& camera, const ViewSize& size, const Eigen::Vector2d& pixel);

/// The point under a pixel in the plane through a place that faces the camera [m]: where a drag of that place leads.
Eigen::Vector3d in_image_plane(const Camera& camera, const ViewSize& size, const Eigen::Vector2d& pixel,
                               const Eigen::Vector3d& place_m);

/// The first intersection of a ray with a drawn surface.
struct SurfaceHit {
    int triangle = 0;         // index in DrawnSurface
    Eigen::Vector3d weights;  // barycentric coordinates in the triangle, sum 1
    double distance_m = 0.0;  // from the ray's origin

    /// Position of this material point for other node positions, for example at rest [m].
    Eigen::Vector3d place(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions_m) const;
};
/// Finds the first intersection. For a closed surface only its outside counts. Returns empty if the ray misses. Tests
/// all triangles: takes time proportional to their number.
///
/// @param positions_m  of the nodes, 3 x n, as drawn
std::optional<SurfaceHit> pick_surface(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions_m,
                                       const Ray& ray);

}  // namespace myo::ui::viewport
