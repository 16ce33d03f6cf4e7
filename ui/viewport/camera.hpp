#pragma once

#include <Eigen/Core>

#include <optional>

#include "mesh/surface_mesh.hpp"

namespace myo::ui::viewport {

/// Turntable camera: z stays up. Lengths in metres, angles in radians.
struct Camera {
    Eigen::Vector3d target = Eigen::Vector3d::Zero();
    double distance = 1.0;       // from eye to target
    double yaw = -1.0;           // of the eye around z; 0 = looking from +x
    double pitch = 0.4;          // of the eye above the horizon
    double field_of_view = 0.5;  // vertical
    double scene_radius = 1.0;   // sets the clipping planes
    bool orthographic = false;   // parallel projection; lengths at the target as in the perspective one

    bool operator==(const Camera&) const = default;
};

/// Size of a view [pixels].
struct ViewSize {
    int width = 1;
    int height = 1;

    double aspect() const { return static_cast<double>(width) / static_cast<double>(height); }
    bool operator==(const ViewSize&) const = default;
};

/// Unit vectors of the view in the world.
struct CameraAxes {
    Eigen::Vector3d right;
    Eigen::Vector3d up;
    Eigen::Vector3d back;  // from the target to the eye
};
CameraAxes camera_axes(const Camera& camera);

/// From the eye to the target [m]. Of a parallel projection the eye stands back far enough to have all in front of it.
double eye_distance(const Camera& camera);

Eigen::Matrix4d view_matrix(const Camera& camera);
/// OpenGL's, depth -1 to 1.
Eigen::Matrix4d projection_matrix(const Camera& camera, const ViewSize& size);

/// Where a world point falls: x, y in pixels from the upper left corner of the view, z the distance before the eye [m].
/// Empty when the point is behind the eye.
std::optional<Eigen::Vector3d> project(const Camera& camera, const ViewSize& size, const Eigen::Vector3d& point);

/// Metres per pixel at the target.
double metres_per_pixel(const Camera& camera, const ViewSize& size);

/// Turns by a drag of (dx, dy) pixels; the pitch stops short of the poles.
Camera orbit(Camera camera, double dx, double dy);
/// Moves so that the target plane follows the cursor.
Camera pan(Camera camera, const ViewSize& size, double dx, double dy);
/// Scales the distance; the point of the target plane under the cursor (pixels) stays where it is.
Camera zoom(Camera camera, const ViewSize& size, double factor, const Eigen::Vector2d& cursor);
/// Whole box in view, same direction.
Camera fit(Camera camera, const ViewSize& size, const Box& box);

enum class StandardView { oblique, from_x, from_y, from_z };
/// Same target and distance, seen along an axis (from +x, from -y, from +z).
Camera turn_to(Camera camera, StandardView view);
/// The same, and from the other side when it is seen so already.
Camera turn_to_or_round(const Camera& camera, StandardView view);

}  // namespace myo::ui::viewport
