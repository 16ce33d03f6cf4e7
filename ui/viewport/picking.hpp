#pragma once

#include <Eigen/Core>

#include <optional>

#include "viewport/camera.hpp"
#include "viewport/drawn_surface.hpp"

namespace myo::ui::viewport {

/// From the eye through a pixel, counted from the upper left corner of the view.
struct Ray {
    Eigen::Vector3d origin_m;
    Eigen::Vector3d direction;  // unit
};
Ray ray_through(const Camera& camera, const ViewSize& size, const Eigen::Vector2d& pixel);

/// Where a ray meets a drawn surface first.
struct SurfaceHit {
    int triangle = 0;
    Eigen::Vector3d weights;  // barycentric, of the triangle's corners
    double distance_m = 0.0;

    /// The same place with the nodes elsewhere, as at rest.
    Eigen::Vector3d place(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions_m) const;
};
/// @param positions_m  of the nodes. Of a closed surface the outside counts only.
std::optional<SurfaceHit> pick_surface(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions_m,
                                       const Ray& ray);

}  // namespace myo::ui::viewport
